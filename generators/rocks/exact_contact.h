// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/height_map.h"
#include "generators/rocks/lowering_plane.h"
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

/// A rock over a cell of the map, ready to be lowered onto what is there.
struct HeldRock {
    std::span<const Vec3> vertices; // relative to its centre's height and the middle of the cell
                                    // that it is over [m]
    std::span<const Mesh::Triangle> triangles;
    const Footprint& under;
    int column = 0; // of the map, over which the centre is
    int row = 0;
    Vec2 offset{0.0, 0.0}; // of the centre from the middle of the cell [m]
    double height = 0;     // of the centre [m]
    double sink = 0;       // by how much it sinks into the ground [m]
};

/// Measures how far a rock can be lowered before it touches anything, from the triangles
/// themselves. Keeps its memory from one rock to the next.
class ExactContact {
  public:
    /// Places where the rock is nearest to what is below it: corners of the areas, seen from above,
    /// that a triangle of its underside and one of a top have in common. The least of their gaps is
    /// exactly how far the rock can be lowered, if it is less than `margin` [m]. Those that are
    /// wider than the least by `more` [m] may be left out.
    const std::vector<Gap>& gaps(const HeldRock& rock, const Neighbourhood& around, double margin,
                                 double more);

  private:
    /// A triangle seen from above, counter-clockwise in (x, z): its plane as a height.
    struct Plan {
        Plan(const Vec3& a, const Vec3& b, const Vec3& c);

        double height(double x, double z) const {
            return corners[0].y + slope_x * (x - corners[0].x) + slope_z * (z - corners[0].z);
        }

        std::array<WideVec3, 3> corners;
        double slope_x = 0;
        double slope_z = 0;
        float low = 0; // the least and the greatest height
        float high = 0;
        Imath::Box2f box; // (x, z)
    };
    struct CommonArea;

    /// Calls visit(cell of the footprint) for the near ones that a box reaches into.
    template <class Visit>
    void each_near(const HeldRock& rock, double cell, const Imath::Box2f& box,
                   const Visit& visit) const;
    void mark(const HeldRock& rock, const Neighbourhood& around, double margin);
    void add_ground(const HeldRock& rock, const Neighbourhood& around, const Vec2& centre);
    void add_top(const HeldRock& rock, double cell, const Vec3& a, const Vec3& b, const Vec3& c);
    void add_pair(const Plan& under, const Plan& top);
    void add_gap(const Vec2& place, double under, double height, const WideVec3& normal);
    void add_rock(const HeldRock& rock, const Neighbourhood& around, std::uint32_t other,
                  const WideVec3& centre);

    std::vector<char> near_; // cells of the footprint that are within the margin
    bool near_ground_ = false;
    Imath::Box2f near_box_;
    std::vector<std::uint32_t> others_;
    std::vector<Plan> under_; // triangles of the rock's underside in such cells
    // Of each cell of the footprint the triangles of `under_` in it: where its list begins, and
    // links of a list: a triangle, and the next link.
    std::vector<std::int32_t> first_;
    struct Link {
        std::uint32_t triangle;
        std::int32_t next;
    };
    std::vector<Link> links_;
    std::vector<std::uint32_t> met_; // of each triangle of `under_`, the last top it was tried with
    std::uint32_t tops_ = 0;
    Vec2 offset_{0.0, 0.0};
    double least_ = 0; // gap so far
    double more_ = 0;
    std::vector<Vec3> posed_;
    std::vector<Gap> gaps_;
};

} // namespace scree::rocks
