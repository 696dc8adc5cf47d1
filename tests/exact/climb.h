// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"

#include <array>
#include <functional>

namespace scree::tests {

using Place = std::array<double, 3>;

/// A local maximum near `start` of a continuous, non-smooth function, by gradient sampling (Burke,
/// Lewis & Overton 2005): the shortest convex combination of gradients around a point leads along
/// ridges, where a single gradient leads across them. Coordinates are scaled to the function's
/// variation. Ends early when the function exceeds `enough`.
Place climb(const std::function<double(const Place&)>& value, Place start, double enough,
            Random& random);

} // namespace scree::tests
