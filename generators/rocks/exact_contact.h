// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/lowering_plane.h"
#include "generators/rocks/surroundings.h"

namespace scree::rocks {

/// A rock over what is there, ready to be lowered onto it.
struct HeldRock {
    std::span<const Vec3> vertices; // relative to its centre [m]
    std::span<const Mesh::Triangle> triangles;
    WideVec3 centre{0, 0, 0};
    double sink = 0; // by how much it sinks into the ground [m]
};

/// Measures how far a rock can be lowered before it touches anything, from the triangles
/// themselves. Keeps its memory from one rock to the next.
class ExactContact {
  public:
    /// Places where the rock is nearest to what is below it: corners of the areas, seen from above,
    /// that a triangle of its underside and one of a top have in common, and over a plane its
    /// vertices. The least of their gaps is exactly how far the rock can be lowered (raised, if it
    /// is negative). Those that are wider than the least by `more` [m] may be left out.
    const std::vector<Gap>& gaps(const HeldRock& rock, const Surroundings& tops,
                                 const Ground& ground, double more);

  private:
    void lower_bound_by_vertices(const HeldRock& rock, const Surroundings& tops,
                                 const Ground& ground);
    void add_ground(const HeldRock& rock, const Ground& ground);
    void add_triangle(const Plan& under, const Surroundings& tops);
    void add_pair(const Plan& under, const Surroundings::Top& top);
    void add_gap(const WideVec3& under, double height, const WideVec3& normal, std::uint32_t below);
    bool matters(double height) const { return height <= least_ + more_; }

    WideVec3 offset_{0, 0, 0}; // of the rock's centre from the origin of the tops
    double least_ = 0;         // gap so far
    double more_ = 0;
    std::vector<WideVec3> points_; // the vertices, relative to the origin of the tops
    std::vector<Gap> gaps_;
};

} // namespace scree::rocks
