// SPDX-License-Identifier: GPL-3.0-or-later
// How a mesh's UVs lie on its surface.
#pragma once

#include "geometry/mesh/mesh.h"

namespace scree {

/// Right-angled axes of length 1 at a point of a surface; `bitangent` points to where v grows.
struct UvAxes {
    Vec3 tangent{1.0F, 0.0F, 0.0F};
    Vec3 bitangent{0.0F, 1.0F, 0.0F};
    Vec3 normal{0.0F, 0.0F, 1.0F};
};

/// The frames that tangent-space normal maps are relative to, made as MikkTSpace makes them
/// (Mikkelsen 2008): per vertex the mean of its faces' directions of u, by angle and apart for
/// mirrored faces, interpolated over the face and put at right angles to the shading normal.
class UvFrames {
  public:
    /// `mesh` has UVs and must outlive the frames; without normals its faces are flat.
    explicit UvFrames(const Mesh& mesh);

    UvAxes at(std::uint32_t triangle, const Vec3& barycentric) const;

  private:
    Vec3 vertex_normal(std::uint32_t triangle, std::size_t corner) const;

    const Mesh& mesh_;
    std::vector<std::array<Vec3, 2>> tangents_; // per vertex, of upright and of mirrored faces
};

/// How long one unit of u and of v is on the surface.
struct UvScale {
    Vec2 size{0.0, 0.0}; // mean over the surface [m]
    double spread = 0;   // standard deviation over mean, the larger of the two
};

/// Of the triangles that have an area in UV; {0, 0} without any.
UvScale uv_scale(const Mesh& mesh);

} // namespace scree
