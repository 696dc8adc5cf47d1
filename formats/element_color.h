// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/warn.h"
#include "model/aggregate.h"

#include <span>

namespace scree {

/// The display-encoded colour of an element in a drawing: that of its material when it is uniform,
/// otherwise (no material, glass, a procedural) the `palette_color` of its prototype.
Color element_color(const Aggregate& aggregate, const Instance& instance);

/// Names, once for each aggregate, the components whose procedural `element_color` replaces.
void warn_of_plain_colors(std::span<const Aggregate> aggregates, const Warn& warn);

} // namespace scree
