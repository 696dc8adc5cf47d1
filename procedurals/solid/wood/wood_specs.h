// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree {

std::vector<ParamSpec> wood_specs(); // of procedural.wood

} // namespace scree
