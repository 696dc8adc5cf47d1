// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <functional>

namespace scree {

/// Depth [m] below a face of a box at (u, v) in [-1, 1]^2, 0 at the face's rim.
using FaceRelief = std::function<double(double u, double v)>;

/// A box with the given sides [m], centred on the origin, with edges rounded by `radius` [m]. Every
/// face maps to the whole UV square. `inner_lines` in (-1, 1) subdivide the flat part of each face
/// for `relief`. Has normals when there is no relief.
Mesh rounded_box(const Vec3& sides, double radius, const std::vector<double>& inner_lines = {},
                 const FaceRelief& relief = {});

} // namespace scree
