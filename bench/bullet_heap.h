// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <optional>

namespace scree::bench {

/// The cost of settling a heap with a physics engine, and its final state.
struct BulletHeap {
    double cpu_seconds = 0;
    double simulated_seconds = 0;
    double speed = 0;   // final mean speed [component lengths per second]
    double deepest = 0; // final maximum penetration [component lengths]
};

/// Drops `count` randomly rotated convex hulls of the mesh into a box with Bullet, until they are
/// at rest (mean speed below a tenth of a component length per second) or 8 simulated seconds have
/// passed. Empty if the bench was built without Bullet (libbullet-dev).
std::optional<BulletHeap> drop_with_bullet(const Mesh& mesh, int count);

} // namespace scree::bench
