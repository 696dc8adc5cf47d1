// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells/cells_text.h"

#define global
namespace scree::solid {
#include "procedurals/solid/cells/beds.cl"
#include "procedurals/solid/cells/creases.cl"
#include "procedurals/solid/cells/spots.cl"
} // namespace scree::solid
#undef global
