// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"

#include <array>
#include <functional>

namespace scree::tests {

using Place = std::array<double, 3>;

/// A place near `start` where a continuous function with kinks has a local maximum, by gradient
/// sampling (Burke, Lewis & Overton 2005): the shortest combination of gradients around a place
/// leads up along ridges, where one gradient leads across. Coordinates are in units of what the
/// function changes over. Ends early where the function exceeds `enough`.
Place climb(const std::function<double(const Place&)>& value, Place start, double enough,
            Random& random);

} // namespace scree::tests
