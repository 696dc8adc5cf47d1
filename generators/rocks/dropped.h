// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/rocks_settings.h"
#include "model/generator.h"

namespace scree::rocks {

/// What would make a bake too large, told before it begins. Throws Error, located.
void check_dropped(const RocksSettings& settings);

/// Rocks that fall onto the ground and each other.
Aggregate bake_dropped(const RocksSettings& settings, const Context& context);

} // namespace scree::rocks
