// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

namespace scree {

/// The display-encoded colour of an element in a drawing: its material's own where that is one
/// colour, or one of a palette; where it has none, is glass or comes from a procedural, the
/// component's of `palette_color`.
Color element_color(const Aggregate& aggregate, const Instance& instance);

} // namespace scree
