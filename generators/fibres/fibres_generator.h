// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "model/generator.h"

namespace scree {

/// generator.fibres: aggregates of staple fibres.
Plugin<Generator> fibres_plugin();

} // namespace scree
