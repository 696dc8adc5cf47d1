// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/generator.h"

namespace scree {

/// generator.elements: discrete element textures, small pictures or meshes evenly spread over a
/// region by Poisson-disk sampling (Kita & Miyata 2012).
Plugin<Generator> elements_plugin();

} // namespace scree
