// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/table.h"

namespace scree {

/// material.fibre, with its presets.
Plugin<MakeMaterial> fibre_plugin();

} // namespace scree
