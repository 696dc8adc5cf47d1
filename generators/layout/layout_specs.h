// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree {

/// The parameters of generator.layout.
std::vector<ParamSpec> layout_specs();

} // namespace scree
