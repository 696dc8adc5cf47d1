// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells_text.h"

#define global
namespace scree::solid {
#include "procedurals/solid/beds.cl"
#include "procedurals/solid/creases.cl"
#include "procedurals/solid/spots.cl"
} // namespace scree::solid
#undef global
