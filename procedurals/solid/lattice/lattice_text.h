// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/float4.h"
#include "procedurals/solid/lattice/text_as_cpp.h"

#define global
#define LATTICE_TEXT_ON_HOST
namespace scree::solid {
#include "procedurals/solid/lattice/lattice.cl"

#include "procedurals/solid/lattice/cell_vector.h"
} // namespace scree::solid
#undef LATTICE_TEXT_ON_HOST
#undef global
