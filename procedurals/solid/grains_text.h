// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells_text.h"

#define global
namespace scree::solid {
#include "procedurals/solid/grains.cl"
} // namespace scree::solid
#undef global
