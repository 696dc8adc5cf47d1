// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "core/random.h"
#include "geometry/mesh/signed_distance_grid.h"

#include <cstdint>
#include <vector>

namespace scree::fibres {

/// The points of a shape that are deeper than `depth` [m], to draw from.
class Interior {
  public:
    /// `shape` must outlive this.
    Interior(const SignedDistanceGrid& shape, double depth);

    /// No point is that deep.
    bool empty() const { return cells_.empty(); }

    /// A point uniform in it.
    Vec3 draw(Random& random) const;

  private:
    const SignedDistanceGrid* shape_;
    float depth_;
    std::vector<std::uint32_t> cells_; // between samples, of which a corner is that deep
};

/// Where fibres begin on a surface.
struct Root {
    Vec3 position; // [m]
    Vec3 normal;   // of the surface, of length 1
};

/// `count` roots evenly spread over a mesh.
struct Roots {
    std::vector<Root> all;
    double spacing = 0; // no two are nearer to each other [m]
};
Roots roots_on(const Mesh& mesh, std::size_t count, std::uint64_t seed, const Context& context);

} // namespace scree::fibres
