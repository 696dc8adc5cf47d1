// SPDX-License-Identifier: GPL-3.0-or-later
// The strands of a World.
#pragma once

#include "geometry/mesh/strands.h"
#include "render/world/shape_tree.h"

#include <ImathVec.h>

namespace scree {

/// What instances of the same strands share. The vertices and segments are Embree's own.
struct StrandTree : ShapeTree {
    const Strands* strands = nullptr;
    const Imath::V4f* vertices = nullptr;  // position and radius [m]
    const std::uint32_t* firsts = nullptr; // of each segment, its first vertex
};

/// A point of a strand's surface, in the object's frame.
struct StrandPoint {
    Vec3 position;
    Vec3 normal;              // unit, outwards
    Vec3 axis;                // unit, towards the tip
    float radius = 0;         // [m]
    float fraction = 0;       // of the segment
    float segment_length = 0; // about [m]
};

/// The strand that a segment belongs to, by the segment's first vertex.
std::size_t strand_of(const Strands& strands, std::uint32_t first);

/// The point of a segment's surface nearest to `p`, which lies near it. `u`: about what fraction of
/// the segment it is at. Embree's own hits lie up to 5% of the radius off the surface, and so do
/// their normals (Embree's issue 332).
StrandPoint onto_segment(const StrandTree& tree, std::uint32_t segment, const Vec3& p, float u);

} // namespace scree
