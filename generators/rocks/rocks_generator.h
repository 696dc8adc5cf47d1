// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "model/generator.h"

namespace scree {

/// generator.rocks: rocks of various sizes on the ground.
Plugin<Generator> rocks_plugin();

} // namespace scree
