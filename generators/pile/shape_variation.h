// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/plane/field.h"

namespace scree {

/// How a component's shapes differ, all about the centre of its bounding box and along its longest
/// side.
struct ShapeVariation {
    std::uint32_t shapes = 1;
    double bend = 0;       // most angle between its ends, towards any side [rad]
    double twist = 0;      // most angle by which its ends are turned against each other [rad]
    double stretch = 0;    // most share by which it is longer or shorter; its volume stays
    Range scale{1.0, 1.0}; // even over the shapes

    bool any() const {
        return bend > 0 || twist > 0 || stretch > 0 || scale.low != 1 || scale.high != 1;
    }
};

/// One deformation of space that keeps closed meshes closed.
struct Deformation {
    Vec3 centre{0, 0, 0};
    Vec3 along{1, 0, 0}; // the axis
    Vec3 aside{0, 1, 0}; // across it: where it bends to
    double length = 1;   // of the axis [m]: from the centre half of it to both sides
    double stretch = 1;  // along; across, what keeps the volume
    double twist = 0;    // from end to end [rad]
    double bend = 0;     // likewise
    double scale = 1;

    Vec3 point(const Vec3& p) const;
    /// The unit normal at `point(p)` of a surface with normal n at p.
    Vec3 normal(const Vec3& p, const Vec3& n) const;
};

/// Shape number `index` of them; equal positions stay equal. Throws Error where the mesh is so wide
/// that it could fold over when bent.
Mesh varied_shape(const Mesh& mesh, const ShapeVariation& variation, std::uint64_t seed,
                  std::uint32_t index);

} // namespace scree
