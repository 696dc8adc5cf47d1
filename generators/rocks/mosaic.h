// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/rocks_settings.h"
#include "model/generator.h"

namespace scree::rocks {

/// Rocks that fill the ground without gaps between sizes: one power diagram in which every cell has
/// its prescribed area, in place of the exclusive selection of Sakurai & Miyata.
Aggregate bake_mosaic(const RocksSettings& settings, const Context& context);

} // namespace scree::rocks
