// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/lattice/lattice_text.h"

#define global
namespace scree::solid {
#include "procedurals/solid/solid.cl"
} // namespace scree::solid
#undef global
