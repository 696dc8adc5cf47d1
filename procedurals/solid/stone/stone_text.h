// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells/cells_shapes_text.h"
#include "procedurals/solid/cells/grains_text.h"

#define global
namespace scree::solid {
#include "procedurals/solid/stone/stone.cl"
} // namespace scree::solid
#undef global
