// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"

namespace scree {

using MakeProcedural = std::shared_ptr<const Procedural>(const Params& params);

Registry<MakeProcedural> procedural_table(); // procedural.checker, ...

} // namespace scree
