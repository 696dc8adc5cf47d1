// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "geometry/rock/rock_settings.h"

#include <algorithm>

namespace scree::tests {

/// Random parameters over their whole ranges.
inline RockSettings extreme_rock(std::uint64_t i) {
    Random random(7, Purpose::test, i);
    const auto either = [&](double low, double high) { // an end as often as what lies between
        const double u = random.uniform(-0.5, 1.5);
        return low + (high - low) * std::clamp(u, 0.0, 1.0);
    };
    RockSettings settings;
    settings.b_over_a = either(least_axis, 1);
    settings.c_over_a = std::min(settings.b_over_a, either(least_axis, 1));
    settings.faces = either(4, 20);
    settings.scatter = either(0, 0.8);
    settings.wear = either(0, 1);
    settings.chips = int(either(0, 40));
    settings.scars = int(either(0, 12));
    settings.cracks = int(either(0, 6));
    settings.hackle = either(0, 0.2);
    settings.rough = either(0, 0.2);
    settings.hurst = either(0.3, 1);
    settings.strata = either(0, 2);
    settings.seed = i;
    return settings;
}

} // namespace scree::tests
