// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <array>
#include <optional>

namespace scree {

/// Where a line along z crosses a triangle.
struct LineCrossing {
    double z;
    int turn; // +1 where the surface faces down: into the body for faces that look outwards
};

/// The crossing of the line through (p.x, p.y), if any. Lines on an edge or a corner count for
/// exactly one of the triangles round it on each side, so that along every line through a closed
/// surface the turns add up to the winding number, provided that its triangles share their corners
/// to the last bit.
std::optional<LineCrossing> line_crossing(const std::array<Imath::V3d, 3>& corners, const Vec2& p);

} // namespace scree
