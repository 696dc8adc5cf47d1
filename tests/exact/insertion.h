// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/exact/disk_set.h"

namespace scree::tests {

/// What was found by trying to add a sample to a set.
struct Insertion {
    std::size_t fitted = 0;  // random darts that conflict with no sample
    std::size_t climbs = 0;  // searches from the darts that came closest to fitting
    std::size_t reached = 0; // of those, how many found room, 1e-9 of an axis or more of it
    double highest = 0;      // margin found
};

/// Throws darts of every class, uniformly over the domain, or its part in `window`, and over the
/// angles, and climbs from the best of each small square, over position and angle, towards places
/// with the most room. Where coverage has no closed form this is the closest test we know; it can
/// miss room, but not invent any.
Insertion try_to_insert(const DiskSet& set, std::size_t darts, std::uint64_t seed,
                        const std::optional<Box2>& window = {});

} // namespace scree::tests
