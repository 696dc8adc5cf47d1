// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/box_grid.h"

#include <algorithm>

namespace scree {

BoxGrid::BoxGrid(std::span<const Box2> boxes, const Box2& frame, bool torus, double boxes_per_cell)
    : frame_(frame), torus_(torus), period_(frame.size()) {
    const double cells = std::clamp(double(boxes.size()) / boxes_per_cell, 1.0, 1.6e7);
    const double side = std::sqrt(std::max(period_.x * period_.y, 1e-300) / cells);
    for (int axis = 0; axis < 2; ++axis) {
        count_[axis] =
            static_cast<std::int64_t>(std::clamp(std::round(period_[axis] / side), 1.0, 16384.0));
        size_[axis] = period_[axis] > 0 ? period_[axis] / double(count_[axis]) : 1;
    }
    first_.assign(std::size_t(count_[0] * count_[1]) + 1, 0);
    for (const Box2& box : boxes)
        for_each_cell(box, [&](std::size_t cell, int, int) { ++first_[cell + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i)
        first_[i] += first_[i - 1];
    entries_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        for_each_cell(boxes[i], [&](std::size_t cell, int turns_x, int turns_y) {
            entries_[next[cell]++] = {i, static_cast<std::int16_t>(turns_x),
                                      static_cast<std::int16_t>(turns_y)};
        });
}

template <class Add>
void BoxGrid::for_each_cell(const Box2& box, const Add& add) const {
    const std::int64_t x1 = cell_of(box.max.x, 0);
    const std::int64_t y1 = cell_of(box.max.y, 1);
    for (std::int64_t y = cell_of(box.min.y, 1); y <= y1; ++y)
        for (std::int64_t x = cell_of(box.min.x, 0); x <= x1; ++x) {
            const auto turns = [](std::int64_t cell, std::int64_t count) {
                return static_cast<int>(std::floor(double(cell) / double(count)));
            };
            const int tx = turns(x, count_[0]);
            const int ty = turns(y, count_[1]);
            add(std::size_t((y - ty * count_[1]) * count_[0] + (x - tx * count_[0])), -tx, -ty);
        }
}

// The number of rings to search around a cell: on a torus up to one period, beyond which there are
// only images of visited boxes; in the plane up to the border of the grid.
std::int64_t BoxGrid::ring_count(std::int64_t x, std::int64_t y) const {
    if (entries_.empty())
        return -1;
    if (torus_)
        return std::max(count_[0], count_[1]) + 1;
    return std::max({x, y, count_[0] - 1 - x, count_[1] - 1 - y});
}

double BoxGrid::ring_distance(const Vec2& point, std::int64_t x, std::int64_t y,
                              std::int64_t ring) const {
    double distance = std::numeric_limits<double>::infinity();
    const std::int64_t cell[] = {x, y};
    for (int axis = 0; axis < 2; ++axis) {
        const double low = frame_.min[axis] + double(cell[axis] - ring) * size_[axis];
        const double high = frame_.min[axis] + double(cell[axis] + ring + 1) * size_[axis];
        distance = std::min({distance, point[axis] - low, high - point[axis]});
    }
    return distance;
}

} // namespace scree
