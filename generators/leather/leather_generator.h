// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/generator.h"

namespace scree {

/// generator.leather: a height map of cristae and sulci that tiles, and a shape displaced by it
/// (after Sakurai & Miyata 2014, section 5.3).
Plugin<Generator> leather_plugin();

} // namespace scree
