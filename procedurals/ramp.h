// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/table.h"

namespace scree {

Plugin<MakeProcedural> ramp_plugin();

} // namespace scree
