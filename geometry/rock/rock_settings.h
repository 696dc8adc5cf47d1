// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace scree {

inline constexpr double least_axis = 0.12; // as a share of the longest

/// What a rock is like. Lengths are in halves of its longest axis.
struct RockSettings {
    double b_over_a =
        0.7; // axes a >= b >= c; fragments average 0.7 and 0.5 (Michikami et al. 2016)
    double c_over_a = 0.5;
    double faces = 7;      // mean count of large faces; 6 are of the joints (Domokos et al. 2020)
    double scatter = 0.32; // of the three joint sets' normals, standard deviation
    double wear = 0.1;     // 0: just broken; 1: a pebble
    int chips = 14;        // corners knocked off
    int scars = 4;         // hollows where flakes came off
    int cracks = 0;
    double hackle = 0.05; // height of the relief of small broken faces
    double rough = 0.03;  // height of the self-affine relief
    double hurst = 0.8;   // its exponent (Bouchaud 1997)
    double strata = 0;    // how far beds stand out
    std::uint64_t seed = 0;
};

} // namespace scree
