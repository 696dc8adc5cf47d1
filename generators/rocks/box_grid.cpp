// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/box_grid.h"

#include <numeric>

namespace scree::rocks {

void BoxGrid::fill(std::span<const Imath::Box2f> boxes, double boxes_per_cell, int most_columns) {
    Imath::Box2f all;
    for (const Imath::Box2f& box : boxes)
        all.extendBy(box);
    if (boxes.empty())
        all = {Vec2f(0.0F), Vec2f(0.0F)};
    low_ = all.min;
    const Vec2f size = all.size();
    const double cells = std::max(1.0, double(boxes.size()) / boxes_per_cell);
    const double side = std::max(std::sqrt(double(size.x) * double(size.y) / cells),
                                 double(std::max(size.x, size.y)) / most_columns);
    per_cell_ = side > 0 ? static_cast<float>(1 / side) : 1.0F;
    width_ = std::clamp(static_cast<int>(size.x * per_cell_) + 1, 1, most_columns);
    depth_ = std::clamp(static_cast<int>(size.y * per_cell_) + 1, 1, most_columns);

    starts_.assign(std::size_t(width_) * std::size_t(depth_) + 1, 0);
    for (const Imath::Box2f& box : boxes)
        each_cell(box, [&](std::size_t cell) { ++starts_[cell + 1]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    members_.resize(starts_.back());
    next_.assign(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t k = 0; k < boxes.size(); ++k)
        each_cell(boxes[k], [&](std::size_t cell) { members_[next_[cell]++] = k; });
}

} // namespace scree::rocks
