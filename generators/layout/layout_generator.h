// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/generator.h"

namespace scree {

/// generator.layout: components on a plane, at random angles and scales, whose exclusive regions
/// never overlap (Sakurai & Miyata 2014).
Plugin<Generator> layout_plugin();

} // namespace scree
