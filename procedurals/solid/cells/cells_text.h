// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/solid_text.h"

#define global
namespace scree::solid {
#include "procedurals/solid/cells/cells.cl"
#include "procedurals/solid/cells/hewn.cl"
} // namespace scree::solid
#undef global
