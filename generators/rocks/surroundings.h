// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/box_grid.h"
#include "generators/rocks/height_map.h"
#include "generators/rocks/plan.h"
#include "generators/rocks/rock_surface.h"

#include <memory>

namespace scree::rocks {

/// What the rocks placed so far are known by to one that falls on them.
struct Neighbourhood {
    const HeightMap& map;
    const Ground& ground;
    std::span<const RockSurface> surfaces;
    std::span<const PlacedRock> rocks;
    std::span<const std::shared_ptr<const TopGrid>> tops; // of rocks with many triangles, else null
};

/// The upper triangles of the rocks around a place, and of a ground that is a mesh: what a rock
/// that falls there can touch. Keeps its memory from one place to the next.
class Surroundings {
  public:
    struct Top {
        Plan plan;          // relative to the origin
        std::uint32_t rock; // HeightMap::no_rock for the ground
    };

    /// @param origin near which they are gathered
    /// @param half of the square (x, z) around it that is covered at least [m]
    /// @param sink by how much the ground counts as lower [m]
    void gather(const Neighbourhood& around, const WideVec3& origin, double half, double sink);

    /// Until they are gathered again nothing is covered.
    void forget() { half_ = -1; }

    const WideVec3& origin() const { return origin_; }

    /// Whether all that is within `reach` of a place has been gathered.
    bool covers(const Vec2& place, double reach) const {
        const Vec2 off = place - Vec2(origin_.x, origin_.z);
        return std::max(std::abs(off.x), std::abs(off.y)) + reach <= half_;
    }

    /// Calls visit(top), each once, for those that may be seen in a box (x, z), relative to the
    /// origin; leaves out cells whose highest top is_near(height) declines.
    template <class IsNear, class Visit>
    void each_in(const Imath::Box2f& box, const IsNear& is_near, const Visit& visit) const {
        grid_.each_cell(box, [&](std::size_t cell) {
            if (!is_near(highest_[cell]))
                return;
            for (const std::uint32_t k : grid_.members(cell)) {
                if (!boxes_[k].intersects(box))
                    continue;
                const Vec2f& low = boxes_[k].min;
                // In the first cell that both boxes reach into.
                if (grid_.at({std::max(box.min.x, low.x), std::max(box.min.y, low.y)}) == cell)
                    visit(tops_[k]);
            }
        });
    }

  private:
    void gather_rocks(const Neighbourhood& around);
    void add_rock(const Neighbourhood& around, std::uint32_t number);
    void add(const Vec3& a, const Vec3& b, const Vec3& c, const WideVec3& offset,
             std::uint32_t rock);

    WideVec3 origin_{0, 0, 0};
    double half_ = -1;
    std::vector<Top> tops_;
    std::vector<Imath::Box2f> boxes_; // of each top
    BoxGrid grid_;
    std::vector<double> highest_; // of the tops in each cell
    std::vector<std::uint32_t> rocks_;
    std::vector<Vec3> posed_;
};

} // namespace scree::rocks
