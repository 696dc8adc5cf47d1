// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "generators/pile/fill_solid.h"

#include <optional>

namespace scree {

/// What generator.pile's parameters ask to be filled; nothing: only the surface is covered. Throws
/// Error, located, for a target that is not closed.
std::optional<SolidFill> solid_fill(const Params& params);

/// Beyond it, on the side that the normal points to, nothing of the finished pile is kept.
struct CutPlane {
    Imath::V3d point{0.0, 0.0, 0.0};
    Imath::V3d normal{0.0, 0.0, 1.0};
};

/// That of `cut`, if it is given. Throws Error, located, for a normal that is no direction.
std::optional<CutPlane> cut_plane(const Params& params);

/// The pile less what lies beyond the plane, by the centres of largest inner balls.
Pile cut_open(const Pile& pile, const CutPlane& plane);

/// Throws Error, located at `target`, for one that is not closed, with what needs a closed one.
void check_closed_target(const Params& params, const char* for_what);

} // namespace scree
