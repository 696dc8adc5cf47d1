// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/rocks/resting_rock.h"
#include "geometry/plane/region.h"

#include <functional>

namespace scree::rocks {

/// Which rocks are dropped where.
struct DropProblem {
    const Ground& ground;
    const Region& domain; // of the centres (x, z)
    std::span<const RockSurface> surfaces;
    std::vector<double> sizes; // longest axes, largest first [m]
    /// The surface of rock i when it is of a kind; any number is a kind.
    std::function<std::uint32_t(std::size_t i, std::uint32_t kind)> surface_of;
    /// How likely a place is, for a rock of this size, in [0, 1]; empty: all places are.
    std::function<double(const Vec2& place, double size)> likely;

    RestSettings rest;
    double dip = 0;      // of flat rocks against the flow [rad]
    double flow = 0;     // where water flows to, from +x towards +z [rad]
    int candidates = 32; // places that are tried, of which the lowest is taken
    std::uint64_t seed = 0;
};

/// The cells of the finest map of a domain, which take eight bytes each.
double map_cells(const Region& domain, double smallest, double largest);

/// Drops the rocks one after another, from large to small, each to the lowest of some places near
/// one that is drawn at random, where it turns until it is held (after Wang & Hauser 2018). Rocks
/// for which no place is found are not placed. The result does not depend on the number of threads.
std::vector<PlacedRock> drop_rocks(const DropProblem& problem, const Context& context);

} // namespace scree::rocks
