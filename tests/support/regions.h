// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region_tools.h"

#include <memory>

namespace scree::tests {

/// The region inside a ring.
inline std::shared_ptr<const Region> region_of(const Ring& ring) {
    return std::make_shared<const Region>(triangulate({ring}));
}

/// A square about the origin.
inline std::shared_ptr<const Region> shared_square(double side) {
    const double h = side / 2;
    return region_of({Vec2(-h, -h), Vec2(h, -h), Vec2(h, h), Vec2(-h, h)});
}

} // namespace scree::tests
