// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "geometry/bodies/advance.h"

namespace scree {

/// The support check that generator.pile's parameters ask for: what it finds is added to the facts,
/// and what falls is taken from the pile where it is to be.
void check_support(Pile& pile, const Params& params, Facts& facts);

} // namespace scree
