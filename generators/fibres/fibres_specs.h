// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree::fibres {

/// The parameters of generator.fibres.
std::vector<ParamSpec> fibres_specs();

} // namespace scree::fibres
