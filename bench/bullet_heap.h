// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <optional>

namespace scree::bench {

/// What a physics engine took to bring a heap to rest.
struct BulletHeap {
    double cpu_seconds = 0;
    double simulated_seconds = 0;
    double speed = 0;   // mean, at the end, in component lengths per second
    double deepest = 0; // penetration at the end, in component lengths
};

/// Drops `count` convex hulls of the mesh, turned at random, into a box with Bullet, until they
/// rest (mean speed below a tenth of a component length per second) or 8 seconds have passed. Empty
/// where the bench was built without Bullet (libbullet-dev).
std::optional<BulletHeap> drop_with_bullet(const Mesh& mesh, int count);

} // namespace scree::bench
