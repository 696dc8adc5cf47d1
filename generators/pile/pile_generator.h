// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/generator.h"

namespace scree {

/// generator.pile: components piled on the surface of a shape (Sakurai 2013, chapter 4).
Plugin<Generator> pile_plugin();

} // namespace scree
