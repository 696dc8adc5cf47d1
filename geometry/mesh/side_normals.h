// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

namespace scree {

/// How often a closed mesh winds around a point: 1 inside, 0 outside, -1 inside of a mesh that is
/// inside out (van Oosterom & Strackee 1983); also in between for an open one. Takes all triangles.
double winding_number(const Mesh& mesh, const Imath::V3d& p);

/// Normals that tell on which side of a closed mesh a point is: where the surface is nearest to the
/// point, the dot product of the way from there to the point with the normal has the sign of the
/// distance, also at edges and corners (Baerentzen & Aanaes 2005).
class SideNormals {
  public:
    /// `mesh` must outlive this.
    explicit SideNormals(const Mesh& mesh);

    /// At a place on a triangle: the normal of the facet, the sum of those of an
    /// edge's facets, or, at a corner, of all around it by their angles. Of any length.
    Vec3 at(std::uint32_t triangle, const Vec3& place) const;

  private:
    struct Normals {
        Vec3 facet;
        std::array<Vec3, 3> corners;
        std::array<Vec3, 3> opposite; // of the edge opposite of each corner
    };
    const Mesh* mesh_;
    std::vector<Normals> normals_; // of each triangle
};

} // namespace scree
