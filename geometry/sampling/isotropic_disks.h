// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/sampling/poisson_disk.h"

namespace scree {

/// Points of a maximal Poisson-disk set of one distance, the common case, made for speed.
struct IsotropicDisks {
    std::vector<Vec2> points;
    std::uint64_t trials = 0;
    std::uint64_t unresolved = 0;
};

/// `sample_poisson_disks` for one class of disks without fields and kept samples.
IsotropicDisks sample_isotropic_disks(const Region& domain, bool torus, double distance,
                                      std::uint64_t seed, const Context& context);

} // namespace scree
