// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/table.h"

namespace scree {

Plugin<MakeProcedural> breccia_plugin(); // procedural.breccia

} // namespace scree
