// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region.h"

#include <cstdint>
#include <span>

namespace scree::rocks {

/// A site in the domain for a cell of each area, so that cells of these areas fit about them: the
/// best of some random candidates each (Mitchell 1991), as disks of the areas, from the first on.
/// @param areas largest first [m^2]
std::vector<Vec2> spread_sites(const Region& domain, std::span<const double> areas,
                               std::uint64_t seed);

} // namespace scree::rocks
