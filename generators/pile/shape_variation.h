// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "geometry/mesh/mesh.h"
#include "geometry/plane/field.h"

namespace scree {

/// How much the shapes of a component differ. They are deformed about the centre of the mesh's
/// bounding box and along its longest side, the axis.
struct ShapeVariation {
    std::uint32_t shapes = 1; // how many there are
    double bend = 0;          // the greatest angle between the ends of the axis, to any side [rad]
    double twist = 0;         // the greatest angle between the end faces about the axis [rad]
    double stretch = 0;       // the greatest share by which the length changes; the volume stays
    Range scale{1.0, 1.0};    // sizes, spread evenly over the shapes

    bool any() const {
        return bend > 0 || twist > 0 || stretch > 0 || scale.low != 1 || scale.high != 1;
    }
};

/// A deformation of space; it keeps closed meshes closed.
struct Deformation {
    Vec3 centre{0, 0, 0};
    Vec3 along{1, 0, 0}; // direction of the axis
    Vec3 aside{0, 1, 0}; // at right angles to it: the direction in which the ends bend
    double length = 1;   // of the axis, whose middle is the centre [m]
    double stretch = 1;  // factor along the axis; across it such that the volume stays
    double twist = 0;    // angle from end to end [rad]
    double bend = 0;     // angle from end to end [rad]
    double scale = 1;    // factor of all sizes, about the centre

    Vec3 point(const Vec3& p) const;
    /// The unit normal at `point(p)` of the deformed surface, which had the normal n at p.
    Vec3 normal(const Vec3& p, const Vec3& n) const;
};

/// Throws Error for a mesh so wide that it could fold over when it is bent.
void check_bend(const Mesh& mesh, const ShapeVariation& variation);

/// Shape number `index` of the variation. Equal positions stay equal. Throws as `check_bend`.
Mesh varied_shape(const Mesh& mesh, const ShapeVariation& variation, std::uint32_t index,
                  Random random);

} // namespace scree
