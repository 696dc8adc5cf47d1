// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapes/table.h"

namespace scree {

Plugin<MakeRegion> svg_region_plugin();  // region.svg
Plugin<MakeRegion> path_region_plugin(); // region.path

} // namespace scree
