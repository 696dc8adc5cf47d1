// SPDX-License-Identifier: GPL-3.0-or-later
// Soft bodies as the zero level of a signed field, negative inside.
#pragma once

#include "geometry/mesh/mesh.h"

#include <functional>

namespace scree {

using Vec3d = Imath::V3d;

/// About a signed distance: negative inside, slope near 1 at the surface.
using SignedField = std::function<double(const Vec3d&)>;

/// The zero level of `field` inside `box`, which it must not touch, as a closed mesh: surface nets
/// (Gibson 1998) on cells of side `cell`, each vertex then moved onto the level by Newton's method.
/// Normals are the field's gradients; UVs are polar about the y axis.
Mesh polygonise(const SignedField& field, const Imath::Box3d& box, double cell);

/// The union of two fields, rounded over the width `k` (Quilez' polynomial smooth minimum).
double smooth_union(double a, double b, double k);

/// Distance to a capsule from `a` to `b`.
double capsule(const Vec3d& p, const Vec3d& a, const Vec3d& b, double radius);

/// About the distance to an ellipsoid with the given half axes (Quilez' first-order bound).
double ellipsoid(const Vec3d& p, const Vec3d& center, const Vec3d& half_axes);

} // namespace scree
