// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/exact/disk_set.h"

namespace scree::tests {

/// The result of trying to add a sample to a set.
struct Insertion {
    std::size_t fitted = 0;  // random darts that conflict with no sample
    std::size_t climbs = 0;  // searches, which start from the darts with the largest margins
    std::size_t reached = 0; // searches that found room of at least 1e-9 of an axis
    double highest = 0;      // largest margin found
};

/// Throws darts of every class, uniform over the domain (or its part in `window`) and over angles.
/// From the best dart of each small square it then climbs, over position and angle, towards more
/// room. Used where coverage has no closed form; it may miss room but never reports false room.
Insertion try_to_insert(const DiskSet& set, std::size_t darts, std::uint64_t seed,
                        const std::optional<Box2>& window = {});

} // namespace scree::tests
