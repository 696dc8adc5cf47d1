// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "model/procedural.h"

namespace scree {

Plugin<MakeProcedural> weathered_plugin();

} // namespace scree
