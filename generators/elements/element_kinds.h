// SPDX-License-Identifier: GPL-3.0-or-later
// Which component each element is.
#pragma once

#include "generators/elements/element_shapes.h"

namespace scree {

/// The component of every sample: its class, or where there is one class for several components,
/// one drawn by weight.
std::vector<std::uint32_t> components_of(const std::vector<std::uint32_t>& classes,
                                         const std::vector<ElementShape>& shapes,
                                         std::size_t class_count, std::uint64_t seed);

/// Adds the count and the share of all of every component, `count_1`, `share_1`, ..., where there
/// are several.
void add_shares(const std::vector<std::uint32_t>& components, std::size_t component_count,
                Facts& facts);

} // namespace scree
