// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region.h"

#include <memory>

namespace scree {

/// Placed elements in structure-of-arrays form; all arrays have the same length. Element i is
/// component `component[i]`, its region's bounding-box centre taken to the origin, scaled by
/// `scale[i]`, turned by `angle[i]` [rad, from +x towards +z] and moved to `position[i]` [m]
/// (Sakurai & Miyata, eq. 1).
struct Layout {
    std::vector<std::uint32_t> component;
    std::vector<Vec2> position;
    std::vector<double> angle;
    std::vector<double> scale;
    std::shared_ptr<const Region> domain;

    std::size_t size() const { return component.size(); }
};

} // namespace scree
