// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace scree {

/// A uniform grid of boxes in the plane or on a torus, for neighbour queries. Visitors get the
/// index of a box and the shift [m] of its periodic image near the query. A box that lies in
/// several cells may be visited several times.
class BoxGrid {
  public:
    /// `frame` is the rectangle of the torus, or a box that contains all queries; boxes may extend
    /// beyond it. There is about one cell for every `boxes_per_cell` boxes.
    BoxGrid(std::span<const Box2> boxes, const Box2& frame, bool torus, double boxes_per_cell = 2);

    /// Calls visit(index, shift) for every box in the cell of the point.
    template <class Visit>
    void visit_at(const Vec2& point, const Visit& visit) const {
        visit_cell(cell_of(point.x, 0), cell_of(point.y, 1), visit);
    }

    /// Calls visit(index, shift) for all boxes that may intersect the given one.
    template <class Visit>
    void visit_box(const Box2& box, const Visit& visit) const {
        const std::int64_t x1 = cell_of(box.max.x, 0);
        const std::int64_t y1 = cell_of(box.max.y, 1);
        for (std::int64_t y = cell_of(box.min.y, 1); y <= y1; ++y)
            for (std::int64_t x = cell_of(box.min.x, 0); x <= x1; ++x)
                visit_cell(x, y, visit);
    }

    /// The minimum of distance(index, shift) [m], which must be the distance from `point` to
    /// something inside that box; infinity when there are no boxes.
    template <class Distance>
    double nearest(const Vec2& point, const Distance& distance) const {
        const std::int64_t x = cell_of(point.x, 0);
        const std::int64_t y = cell_of(point.y, 1);
        double best = std::numeric_limits<double>::infinity();
        const auto visit = [&](std::uint32_t index, const Vec2& shift) {
            best = std::min(best, distance(index, shift));
        };
        for (std::int64_t ring = 0; ring <= ring_count(x, y); ++ring) {
            // Everything outside the rings visited so far is at least this far away.
            if (ring > 0 && best <= ring_distance(point, x, y, ring - 1))
                break;
            for (std::int64_t dx = -ring; dx <= ring; ++dx) {
                visit_cell(x + dx, y - ring, visit);
                if (ring > 0)
                    visit_cell(x + dx, y + ring, visit);
            }
            for (std::int64_t dy = 1 - ring; dy < ring; ++dy) {
                visit_cell(x - ring, y + dy, visit);
                visit_cell(x + ring, y + dy, visit);
            }
        }
        return best;
    }

  private:
    struct Entry {
        std::uint32_t index;
        std::int16_t turns_x; // shift of its image in this cell, in periods
        std::int16_t turns_y;
    };

    std::int64_t cell_of(double coordinate, int axis) const {
        const double cell = std::floor((coordinate - frame_.min[axis]) / size_[axis]);
        // In the plane, everything outside the grid belongs to its border cells.
        return static_cast<std::int64_t>(torus_ ? cell
                                                : std::clamp(cell, 0.0, double(count_[axis] - 1)));
    }
    std::int64_t ring_count(std::int64_t x, std::int64_t y) const;
    double ring_distance(const Vec2& point, std::int64_t x, std::int64_t y,
                         std::int64_t ring) const;
    template <class Add>
    void for_each_cell(const Box2& box, const Add& add) const;

    template <class Visit>
    void visit_cell(std::int64_t x, std::int64_t y, const Visit& visit) const {
        Vec2 turn(0, 0);
        if (x < 0 || y < 0 || x >= count_[0] || y >= count_[1]) {
            if (!torus_)
                return;
            turn = {std::floor(double(x) / double(count_[0])),
                    std::floor(double(y) / double(count_[1]))};
            x -= static_cast<std::int64_t>(turn.x) * count_[0];
            y -= static_cast<std::int64_t>(turn.y) * count_[1];
        }
        const std::size_t cell = std::size_t(y * count_[0] + x);
        for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
            const Entry& entry = entries_[i];
            visit(entry.index,
                  Vec2((turn.x + entry.turns_x) * period_.x, (turn.y + entry.turns_y) * period_.y));
        }
    }

    Box2 frame_;
    bool torus_;
    Vec2 period_;             // of the torus
    Vec2 size_;               // of a cell
    std::int64_t count_[2]{}; // cells along each axis
    std::vector<std::uint32_t> first_;
    std::vector<Entry> entries_;
};

} // namespace scree
