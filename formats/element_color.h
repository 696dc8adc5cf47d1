// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

namespace scree {

/// The display-encoded colour of an element in a drawing: that of its material when it is uniform,
/// otherwise (no material, glass, a procedural) the `palette_color` of its prototype.
Color element_color(const Aggregate& aggregate, const Instance& instance);

} // namespace scree
