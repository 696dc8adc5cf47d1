// SPDX-License-Identifier: GPL-3.0-or-later
// Rounded bodies as zero level sets of signed fields.
#pragma once

#include "geometry/mesh/mesh.h"

#include <functional>

namespace scree {

using Vec3d = Imath::V3d;

/// Approximately a signed distance: negative inside, with a gradient of about 1 at the surface.
using SignedField = std::function<double(const Vec3d&)>;

/// The zero level set of `field` as a closed mesh: surface nets (Gibson 1998) on cells of side
/// `cell`, with each vertex moved onto the level set by Newton's method. It must lie inside `box`.
/// Normals are the field's gradients; UVs are the angle about the y axis and the height.
Mesh polygonise(const SignedField& field, const Imath::Box3d& box, double cell);

/// The union of two fields, blended over the width `k` (Quilez' polynomial smooth minimum).
double smooth_union(double a, double b, double k);

/// Distance to a capsule from `a` to `b`.
double capsule(const Vec3d& p, const Vec3d& a, const Vec3d& b, double radius);

/// First-order approximation of the distance to an ellipsoid with the given semi-axes (Quilez).
double ellipsoid(const Vec3d& p, const Vec3d& center, const Vec3d& half_axes);

} // namespace scree
