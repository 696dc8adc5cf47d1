// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree {

/// The parameters of generator.pile.
std::vector<ParamSpec> pile_specs();

} // namespace scree
