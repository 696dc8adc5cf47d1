// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "model/procedural.h"

namespace scree {

Plugin<MakeProcedural> image_plugin(); // procedural.image

} // namespace scree
