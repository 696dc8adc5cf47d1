// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "generators/pile/pile_sites.h"

namespace scree {

/// The components of generator.pile, prepared. Throws Error, located, for a mesh that cannot be
/// piled (see `prepare_component`) and a thickness of what is no sheet.
std::vector<PileKind> pile_kinds(const Params& params);

} // namespace scree
