// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region.h"

namespace scree {

struct Disk {
    Vec2 centre;
    double radius = 0;
};

/// At most `count` large disks inside the region, the largest first and none much inside another:
/// two regions overlap wherever two of their disks do. Each next centre is as far as can be from
/// the edges and from the disks before ("poles", after Gardeyn & Wauters 2024); found on a grid,
/// then by pattern search.
std::vector<Disk> inscribed_disks(const Region& region, std::size_t count);

} // namespace scree
