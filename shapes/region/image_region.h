// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapes/table.h"

namespace scree {

Plugin<MakeRegion> image_region_plugin(); // region.image

} // namespace scree
