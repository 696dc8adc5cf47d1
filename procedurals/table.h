// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "model/procedural.h"

namespace scree {

Registry<MakeProcedural> procedural_table(); // procedural.checker, ...

} // namespace scree
