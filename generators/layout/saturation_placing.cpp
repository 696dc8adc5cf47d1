// SPDX-License-Identifier: GPL-3.0-or-later
// How the search places elements: darts, and what is left of a cell whose middle is free.
#include "generators/layout/saturation_search.h"

#include "geometry/figures/overlap.h"

#include <algorithm>

namespace scree {

namespace {

/// Whether two elements come nearer to each other than `clearance` and their margins; `offset`: the
/// position of the first less that of the second.
bool meet(const LayoutProblem& problem, const Dart& dart, const Dart& other, const Vec2& offset,
          double clearance, std::uint64_t& queries) {
    const CollisionShape& shape = problem.shapes[dart.component];
    const CollisionShape& other_shape = problem.shapes[other.component];
    const double apart = clearance + dart.margin + other.margin;
    const double reach =
        shape.radius() * dart.pose.scale + other_shape.radius() * other.pose.scale + apart;
    if (offset.length2() > reach * reach)
        return false;
    ++queries;
    return overlap(shape, dart.pose, other_shape, other.pose, offset, apart);
}

} // namespace

bool SaturationSearch::try_dart(const Box2& box, std::uint64_t trial) {
    ++counts_.darts;
    const Vec2 position(random_.uniform(box.min.x, box.max.x),
                        random_.uniform(box.min.y, box.max.y));
    const std::optional<Dart> dart = throw_dart_at(layout_, trial, position, random_);
    if (!dart || !others_.is_free(*dart, counts_.queries))
        return false;
    for (const Dart& other : placed_) {
        const Vec2 offset = layout_.domain.nearest_image(position - other.pose.position);
        if (meet(layout_, *dart, other, offset, problem_.clearance, counts_.queries))
            return false;
    }
    placed_.push_back(*dart);
    return true;
}

bool SaturationSearch::is_free(const Dart& dart, const Vec2& offset) {
    for (const Neighbour& other : neighbours_)
        if (meet(layout_, dart, other.dart, offset - other.offset, problem_.clearance,
                 counts_.queries))
            return false;
    return layout_.domain.accepts(layout_.shapes[dart.component], dart.pose,
                                  problem_.clearance + dart.margin);
}

/// Places the element at a point of the cell, at the allowed angle and scale nearest to these, if
/// it is free there.
SaturationSearch::Trial SaturationSearch::try_at(const Vec2f& point, double angle, double scale) {
    ++counts_.darts;
    const Vec2 offset(point);
    const Vec2 position = layout_.domain.wrapped(centre_ + offset);
    if (!layout_.has_class(component_, position))
        return Trial::not_allowed;
    const LayoutFields& fields = layout_.fields;
    double turn = angle - (fields.direction ? radians(fields.direction->at(position)) : 0);
    const Range& range = layout_.rotation;
    if (is_turned_freely_) {
        // The region may look the same after a part of a turn where the component does not: each of
        // these turns is equally likely.
        const double period = problem_.shapes[component_].turn_period;
        const auto times = static_cast<std::uint32_t>(std::lround(2 * pi / period));
        turn += period * random_.below(times);
        turn = range.low + std::fmod(turn - range.low, 2 * pi);
        turn = turn < range.low ? turn + 2 * pi : turn;
    } else {
        const double middle = (range.low + range.high) / 2;
        turn = std::clamp(middle + angle_between(turn, middle), range.low, range.high);
    }
    const double factor = fields.scale ? fields.scale->at(position) : 1;
    const double without_field = std::clamp(scale / factor, layout_.scale.low, layout_.scale.high);
    const Dart dart = layout_.dart(component_, position, turn, without_field);
    if (!is_free(dart, offset))
        return Trial::taken;
    placed_.push_back(dart);
    add_neighbours(dart);
    return Trial::placed;
}

bool SaturationSearch::throw_into(std::size_t first_fragment, const Cell& cell) {
    float sum = 0;
    for (std::size_t i = first_fragment; i < fragments_.size(); ++i)
        sum += fragments_[i].area();
    float left = random_.uniform_float() * sum;
    std::size_t chosen = first_fragment;
    for (; chosen + 1 < fragments_.size(); ++chosen) {
        left -= fragments_[chosen].area();
        if (left < 0)
            break;
    }
    const float u = random_.uniform_float(), v = random_.uniform_float();
    const Vec2f point = fragments_[chosen].at(u, v);
    const double angle = cell.angle + cell.half_angle * random_.uniform(-1, 1);
    const double scale = random_.uniform(cell.low, cell.high);
    if (problem_.shapes[component_].smaller_is_easier && layout_.scale.high > layout_.scale.low) {
        const double larger =
            random_.uniform(scale, scale / layout_.scale.low * layout_.scale.high);
        if (try_at(point, angle, larger) == Trial::placed)
            return true;
    }
    return try_at(point, angle, scale) == Trial::placed;
}

/// For a cell in which no motion exceeds the clearance, so that what is left of it is free at its
/// middle. Returns whether nothing is left; after the last attempt that is always so.
bool SaturationSearch::finish(Cell& cell, std::size_t first_fragment, bool is_last) {
    while (fragments_.size() > first_fragment) {
        const Fragment fragment = fragments_.back();
        const double scale = (cell.low + cell.high) / 2;
        Trial trial = try_at(fragment.centroid(), cell.angle, scale);
        bool is_taken = trial == Trial::taken;
        for (int i = 0; i < 8 && trial != Trial::placed && has_fields(); ++i) {
            const float u = random_.uniform_float(), v = random_.uniform_float();
            trial = try_at(fragment.at(u, v), cell.angle, scale);
            is_taken = is_taken || trial == Trial::taken;
        }
        if (trial == Trial::placed) {
            cover_new(cell, first_fragment);
        } else if (is_taken && !is_last) {
            return false;
        } else {
            counts_.undecided += is_taken ? 1 : 0;
            fragments_.pop_back();
        }
    }
    return true;
}

} // namespace scree
