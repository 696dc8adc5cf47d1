// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/cell_layout.h"

#include "core/random.h"
#include "generators/layout/overlap.h"
#include "generators/sampling/region_tools.h"

#include <algorithm>

namespace scree {

namespace {

// Enough that no two neighbours look alike: each is also turned and scaled.
constexpr std::uint32_t outlines = 24;

// Sizes per octave: between two of them a gap that is a little too small for one is filled by the
// next. Darts that must fail in a row before the next smaller size: the naive method's 10,000 would
// only add cells where the groove network closes the gap anyway.
constexpr double steps_per_octave = 4;
constexpr std::uint64_t cancellations = 1500;

/// The placed cells by a uniform grid that wraps round, each cell of it as wide as the largest.
class TorusPlacements {
  public:
    TorusPlacements(CellLayout& layout, double largest_radius) : layout_(layout) {
        count_ = std::max(1, static_cast<int>(layout.size / (2 * largest_radius)));
        grid_.resize(std::size_t(count_) * std::size_t(count_));
    }

    bool try_place(const Cell& cell) {
        const int x = bin(cell.pose.position.x), y = bin(cell.pose.position.y);
        const int reach = std::min(1, (count_ - 1) / 2); // no bin twice on a small torus
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i)
                for (const std::uint32_t other : at(x + i, y + j))
                    if (overlaps(cell, layout_.cells[other]))
                        return false;
        at(x, y).push_back(static_cast<std::uint32_t>(layout_.cells.size()));
        layout_.cells.push_back(cell);
        return true;
    }

  private:
    int bin(double at) const {
        return std::min(count_ - 1, static_cast<int>(at / layout_.size * count_));
    }
    std::vector<std::uint32_t>& at(int x, int y) {
        return grid_[std::size_t((y + count_) % count_) * std::size_t(count_) +
                     std::size_t((x + count_) % count_)];
    }
    bool overlaps(const Cell& a, const Cell& b) const {
        Vec2 offset = a.pose.position - b.pose.position;
        offset.x -= layout_.size * std::round(offset.x / layout_.size);
        offset.y -= layout_.size * std::round(offset.y / layout_.size);
        return overlap(layout_.shapes[a.shape], a.pose, layout_.shapes[b.shape], b.pose, offset);
    }

    CellLayout& layout_;
    int count_ = 1;
    std::vector<std::vector<std::uint32_t>> grid_;
};

Ring cut_corners(const Ring& ring) {
    Ring cut;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2& a = ring[i];
        const Vec2& b = ring[(i + 1) % ring.size()];
        cut.push_back(a * 0.75 + b * 0.25);
        cut.push_back(a * 0.25 + b * 0.75);
    }
    return cut;
}

} // namespace

double CellLayout::fill() const {
    double sum = 0;
    for (const Cell& cell : cells)
        sum += shapes[cell.shape].area() * cell.pose.scale * cell.pose.scale;
    return sum / (size * size);
}

Region cell_outline(double elongation, double irregularity, std::uint64_t seed,
                    std::uint64_t index) {
    Random random(seed, Purpose::leather_outline, index);
    const auto corners = 5 + random.below(4);
    const double phase = random.uniform();
    const double stretch = std::sqrt(elongation * (1 + 0.4 * irregularity * random.uniform(-1, 1)));
    Ring ring;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle =
            2 * pi * (i + phase + 0.38 * irregularity * random.uniform(-1, 1)) / corners;
        const double radius = 1 + 0.4 * irregularity * random.uniform(-1, 1);
        ring.emplace_back(radius * stretch * std::cos(angle), radius / stretch * std::sin(angle));
    }
    ring = cut_corners(cut_corners(ring));
    const double factor = std::sqrt(pi / 4 / std::abs(signed_area(ring)));
    for (Vec2& p : ring)
        p *= factor;
    return triangulate({ring});
}

CellLayout place_cells(double size, const std::vector<CellKind>& kinds, std::uint64_t seed,
                       std::uint64_t stream, const Context& context) {
    CellLayout layout;
    layout.size = size;
    double radius = 0;
    for (const CellKind& kind : kinds)
        for (std::uint32_t i = 0; i < outlines; ++i) {
            Region outline = cell_outline(kind.elongation, kind.irregularity, seed,
                                          (stream << 20) + layout.shapes.size());
            for (Ring& ring : outline.rings)
                for (Vec2& p : ring)
                    p *= kind.width;
            layout.shapes.emplace_back(outline);
            radius = std::max(radius, layout.shapes.back().radius() * kind.scale.high);
        }
    TorusPlacements placements(layout, radius);
    std::uint64_t trial = 0;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const CellKind& kind = kinds[k];
        const double octaves = std::log2(kind.scale.high / kind.scale.low);
        const int steps = std::max(1, static_cast<int>(std::ceil(octaves * steps_per_octave)));
        for (int step = 0; step < steps; ++step) {
            const double high = kind.scale.high * std::exp2(-octaves * step / steps);
            const double low = kind.scale.high * std::exp2(-octaves * (step + 1) / steps);
            for (std::uint64_t in_a_row = 0; in_a_row < cancellations; ++trial) {
                Random random(seed, Purpose::leather_cell, (stream << 40) | trial);
                Cell cell;
                cell.shape = static_cast<std::uint32_t>(k * outlines) + random.below(outlines);
                const double angle = kind.direction + kind.direction_spread * random.uniform(-1, 1);
                const double scale = random.uniform(low, high);
                cell.pose = Pose({random.uniform(0, size), random.uniform(0, size)}, angle, scale);
                in_a_row = placements.try_place(cell) ? 0 : in_a_row + 1;
                if (trial % 1024 == 0)
                    context.check_cancel();
            }
            context.report("placing cells", double(step + 1) / steps);
        }
    }
    return layout;
}

} // namespace scree
