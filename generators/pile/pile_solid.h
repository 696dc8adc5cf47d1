// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "generators/pile/fill_solid.h"

#include <optional>

namespace scree {

/// What generator.pile's parameters ask to be filled; nothing: only the surface is covered. Throws
/// Error, located, for a target that is not closed.
std::optional<SolidFill> solid_fill(const Params& params);

/// The pile less what lies beyond the plane of `cut`, by the centres of largest inner balls; all of
/// it where there is none.
Pile cut_open(const Pile& pile, const Params& params);

/// Throws Error, located at `target`, for one that is not closed, with what needs a closed one.
void check_closed_target(const Params& params, const char* for_what);

} // namespace scree
