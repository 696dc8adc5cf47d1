// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/procedural.h"

#include <algorithm>
#include <cmath>

namespace scree::tests {

/// The largest difference in colour, value and roughness, and the relative one in slope.
inline double difference(const ShadingSample& a, const ShadingSample& b) {
    double d = std::abs(double(a.value) - double(b.value));
    for (int k = 0; k < 3; ++k) {
        d = std::max(d, std::abs(double(a.color[k]) - double(b.color[k])));
        d = std::max(d, std::abs(double(a.slope[k]) - double(b.slope[k])) /
                            (1 + double(a.slope.length())));
    }
    return std::max(d, std::abs(double(a.roughness) - double(b.roughness)));
}

} // namespace scree::tests
