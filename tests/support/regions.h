// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region_tools.h"

#include <memory>

namespace scree::tests {

/// The region inside a ring.
inline std::shared_ptr<const Region> region_of(const Ring& ring) {
    return std::make_shared<const Region>(triangulate({ring}));
}

} // namespace scree::tests
