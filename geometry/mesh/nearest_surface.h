// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/triangle_distance.h"

#include <optional>
#include <vector>

namespace scree {

/// The nearest point of a mesh, found in a tree of its triangles' boxes.
class NearestSurface {
  public:
    /// Where the surface is nearest to a point.
    struct Point {
        Imath::V3d position;
        Vec3 normal;     // of the surface there, interpolated where the mesh has normals
        double distance; // [m]
        std::uint32_t triangle;
    };

    /// `mesh` has triangles and must outlive this.
    explicit NearestSurface(const Mesh& mesh);

    Point nearest(const Imath::V3d& p) const;

    /// The same, or nothing if no point of the mesh is within `most` [m]; the fewer, the faster.
    std::optional<Point> nearest_within(const Imath::V3d& p, float most) const;

  private:
    struct Node {
        Box3 box;
        std::uint32_t first = 0; // child, the second follows it; or triangle of a leaf
        std::uint32_t count = 0; // of a leaf's triangles, or 0
    };

    void split(std::uint32_t node, std::uint32_t first, std::uint32_t end);
    Point point_on(std::uint32_t triangle, const Imath::V3d& p, const Vec3& at) const;

    const Mesh* mesh_;
    std::vector<std::uint32_t> order_; // of the triangles in the leaves
    std::vector<DistanceTriangle> triangles_;
    std::vector<Node> nodes_;
};

} // namespace scree
