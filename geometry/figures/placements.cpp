// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/figures/placements.h"

#include "geometry/figures/overlap.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

int cell_of(double offset, double cell, int count) {
    return std::clamp(static_cast<int>(std::floor(offset / cell)), 0, count - 1);
}

/// The cells from `low` to `high` in one direction. On a torus indices outside of [0, count) stand
/// for images, and no cell occurs twice.
struct CellSpan {
    int first, last;

    CellSpan(double low, double high, double cell, int count, bool wraps)
        : first(cell_of(low, cell, count)), last(cell_of(high, cell, count)) {
        if (!wraps)
            return;
        first = static_cast<int>(std::floor(low / cell));
        last = std::min(static_cast<int>(std::floor(high / cell)), first + count - 1);
    }
};

std::size_t wrapped(int index, int count) {
    const int remainder = index % count;
    return static_cast<std::size_t>(remainder < 0 ? remainder + count : remainder);
}

} // namespace

Placements::Placements(const LayoutProblem& problem)
    : problem_(problem), clearance_(problem.clearance()) {
    // At most 4096 cells per side, 64 MiB, however small the elements; then cells hold several.
    const Vec2 size = problem.domain.box().size();
    smallest_cell_ = std::max(2 * problem.smallest_radius(), std::max(size.x, size.y) / 4096);
}

Placements::Level& Placements::level_of(double radius) {
    // The first octave whose cells are at least as wide as the element.
    std::size_t octave = 0;
    double cell = smallest_cell_;
    for (; cell < 2 * radius; cell *= 2)
        ++octave;
    if (levels_.size() <= octave)
        levels_.resize(octave + 1);
    Level& level = levels_[octave];
    if (level.first.empty()) {
        const Vec2 size = problem_.domain.box().size();
        const bool wraps = problem_.domain.is_torus();
        level.cell = cell;
        level.width = std::max(1, static_cast<int>(size.x / cell) + (wraps ? 0 : 1));
        level.height = std::max(1, static_cast<int>(size.y / cell) + (wraps ? 0 : 1));
        level.size = wraps ? size / Vec2(level.width, level.height) : Vec2(cell);
        level.first.assign(std::size_t(level.width) * std::size_t(level.height), nobody);
    }
    return level;
}

template <class Visit>
bool Placements::any_near(const Vec2& point, double radius, const Visit& visit) const {
    const Vec2 p = point - problem_.domain.box().min;
    const bool wraps = problem_.domain.is_torus();
    for (const Level& level : levels_) {
        if (level.first.empty())
            continue;
        const double reach = radius + level.cell / 2;
        const CellSpan xs(p.x - reach, p.x + reach, level.size.x, level.width, wraps);
        const CellSpan ys(p.y - reach, p.y + reach, level.size.y, level.height, wraps);
        for (int y = ys.first; y <= ys.last; ++y) {
            const std::size_t row = wrapped(y, level.height) * std::size_t(level.width);
            for (int x = xs.first; x <= xs.last; ++x)
                for (std::uint32_t i = level.first[row + wrapped(x, level.width)]; i != nobody;
                     i = next_[i])
                    if (visit(i, problem_.domain.nearest_image(point - darts_[i].pose.position)))
                        return true;
        }
    }
    return false;
}

bool Placements::is_free(const Dart& dart, std::uint64_t& queries) const {
    const CollisionShape& shape = problem_.shapes[dart.component];
    const double radius = shape.radius() * dart.pose.scale + dart.margin;
    return !any_near(dart.pose.position, radius + clearance_,
                     [&](std::uint32_t i, const Vec2& offset) {
                         const double reach = radius + radii_[i] + clearance_;
                         if (offset.length2() > reach * reach)
                             return false;
                         ++queries;
                         return overlap(shape, dart.pose, problem_.shapes[darts_[i].component],
                                        darts_[i].pose, offset,
                                        clearance_ + dart.margin + darts_[i].margin);
                     }) &&
           problem_.domain.accepts(shape, dart.pose, clearance_ + dart.margin);
}

void Placements::gather(const Vec2& point, double radius,
                        std::vector<std::uint32_t>& elements) const {
    any_near(point, radius, [&](std::uint32_t i, const Vec2& offset) {
        const double reach = radius + radii_[i];
        if (offset.length2() <= reach * reach)
            elements.push_back(i);
        return false;
    });
}

bool Placements::keeps_distance(const Vec2& position, double distance) const {
    return !any_near(position, distance, [&](std::uint32_t, const Vec2& offset) {
        return offset.length2() < distance * distance;
    });
}

bool Placements::try_place(const Dart& dart) {
    const bool is_placed = is_free(dart, queries_);
    if (is_placed)
        place(dart);
    return is_placed;
}

void Placements::place(const Dart& dart) {
    const double radius = problem_.shapes[dart.component].radius() * dart.pose.scale + dart.margin;
    Level& level = level_of(radius);
    const Vec2 p = dart.pose.position - problem_.domain.box().min;
    std::uint32_t& first = level.first[std::size_t(cell_of(p.y, level.size.y, level.height)) *
                                           std::size_t(level.width) +
                                       std::size_t(cell_of(p.x, level.size.x, level.width))];
    next_.push_back(first);
    first = static_cast<std::uint32_t>(darts_.size());
    darts_.push_back(dart);
    radii_.push_back(radius);
}

Layout Placements::layout(std::shared_ptr<const Region> domain) const {
    Layout result;
    for (const Dart& dart : darts_) {
        result.component.push_back(dart.component);
        result.position.push_back(dart.pose.position);
        result.angle.push_back(dart.pose.angle);
        result.scale.push_back(dart.pose.scale);
    }
    result.domain = std::move(domain);
    return result;
}

} // namespace scree
