// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace scree::rocks {

/// Boxes of a plane in square cells: a cell has the numbers of those that may reach into it, in
/// increasing order. Keeps its memory when it is filled again.
class BoxGrid {
  public:
    /// @param boxes_per_cell about how many there are to be
    /// @param most_columns and rows, at least 1
    void fill(std::span<const Imath::Box2f> boxes, double boxes_per_cell, int most_columns);

    /// Calls visit(cell) for the cells that a box reaches into, or the nearest of the border.
    template <class Visit>
    void each_cell(const Imath::Box2f& box, const Visit& visit) const {
        const int first_x = column(box.min.x);
        const int last_x = column(box.max.x);
        const int last_y = row(box.max.y);
        for (int j = row(box.min.y); j <= last_y; ++j)
            for (int i = first_x; i <= last_x; ++i)
                visit(index(i, j));
    }

    /// The cell of a point, or the nearest.
    std::size_t at(const Vec2f& p) const { return index(column(p.x), row(p.y)); }

    std::size_t cell_count() const { return starts_.size() - 1; }
    std::span<const std::uint32_t> members(std::size_t cell) const {
        return std::span(members_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
    }

  private:
    int column(float x) const {
        return std::clamp(static_cast<int>((x - low_.x) * per_cell_), 0, width_ - 1);
    }
    int row(float y) const {
        return std::clamp(static_cast<int>((y - low_.y) * per_cell_), 0, depth_ - 1);
    }
    std::size_t index(int i, int j) const {
        return std::size_t(j) * std::size_t(width_) + std::size_t(i);
    }

    Vec2f low_{0.0F, 0.0F}; // corner of the grid
    float per_cell_ = 1;
    int width_ = 1;
    int depth_ = 1;
    std::vector<std::uint32_t> starts_{0, 0}; // of each cell in `members_`
    std::vector<std::uint32_t> members_;
    std::vector<std::uint32_t> next_; // while it is filled
};

} // namespace scree::rocks
