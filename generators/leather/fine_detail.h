// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/leather/groove_network.h"

namespace scree {

/// What fine detail is made from.
struct FineDetail {
    const LeatherSettings& settings;
    double size = 0;      // edge of the tile [m]
    double direction = 0; // in which hairs leaned, and across which wrinkles run [rad]
    std::uint64_t seed = 0;
};

/// Adds to the heights the detail that is finer than cells and the waves that are longer: wrinkles,
/// the grain of the surface, hair pores, which prefer the junctions of grooves, and undulation.
/// Periodic like the network. Returns the number of pores. Same bytes on any number of threads.
std::size_t add_fine_detail(const FineDetail& detail, const GrooveNetwork& network,
                            std::vector<float>& heights, const Context& context);

} // namespace scree
