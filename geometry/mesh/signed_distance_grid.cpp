// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/signed_distance_grid.h"

#include "geometry/mesh/medial_balls.h"
#include "geometry/mesh/triangle_distance.h"

#include <algorithm>

namespace scree {

namespace {

constexpr std::int32_t none = -1;
constexpr float unknown = 1e18F; // its square is finite

// Samples all around the mesh, the outermost of which lie outside of it.
VoxelGrid grid_round(const Mesh& mesh, double step, double thickness, std::size_t most,
                     double margin) {
    const Box3 box = bounds(mesh);
    const Imath::V3d extent = Imath::V3d(box.size()) + Imath::V3d(thickness + 2 * margin);
    VoxelGrid grid;
    for (grid.side = step;; grid.side *= 1.1) {
        for (int axis = 0; axis < 3; ++axis)
            grid.count[std::size_t(axis)] =
                static_cast<int>(std::ceil(std::min(extent[axis] / grid.side, 1e6))) + 3;
        if (double(grid.count[0]) * grid.count[1] * grid.count[2] <= double(most))
            break;
    }
    const Imath::V3d covered = Imath::V3d(grid.count[0], grid.count[1], grid.count[2]) * grid.side;
    grid.corner = Imath::V3d(box.center()) - covered * 0.5;
    return grid;
}

/// The nearest triangle of every sample: exact next to the surface, and from there propagated from
/// sample to neighbour in the order of distance (the vector distance transform of Danielsson 1980
/// in Dijkstra's order, with triangles in place of points). A triangle is not propagated through a
/// sample that another one is nearer to: the resulting error rarely exceeds a tenth of a step, and
/// only where triangles are that small.
class NearestTriangles {
  public:
    NearestTriangles(const Mesh& mesh, const VoxelGrid& grid)
        : grid_(grid), stride_{1, std::size_t(grid.count[0]),
                               std::size_t(grid.count[0]) * std::size_t(grid.count[1])},
          step_(static_cast<float>(grid.side)), distance_(grid.size(), unknown),
          nearest_(grid.size(), none) {
        triangles_.reserve(mesh.triangles.size());
        hulls_.reserve(mesh.triangles.size());
        for (const Mesh::Triangle& t : mesh.triangles) {
            const std::array<Vec3, 3> corners{mesh.positions[t[0]], mesh.positions[t[1]],
                                              mesh.positions[t[2]]};
            triangles_.emplace_back(corners);
            hulls_.push_back(hull_of(corners));
        }
        for (std::uint32_t t = 0; t < triangles_.size(); ++t)
            mark_near(mesh, t);
        spread();
    }

    float distance(std::size_t i) const { return distance_[i]; }

  private:
    Vec3 position(int i, int j, int k) const { return Vec3(grid_.centre(i, j, k)); }

    static Ball hull_of(const std::array<Vec3, 3>& corners) {
        Ball hull{(corners[0] + corners[1] + corners[2]) / 3, 0};
        for (const Vec3& corner : corners)
            hull.radius = std::max(hull.radius, (corner - hull.centre).length());
        return hull;
    }

    // Takes the triangle if it is nearer than the sample's nearest so far; returns whether it is.
    // Its bounding ball rules out most triangles.
    bool try_triangle(std::size_t at, const Vec3& p, std::int32_t t) {
        const Ball& hull = hulls_[static_cast<std::size_t>(t)];
        const float far = distance_[at] + hull.radius;
        if ((p - hull.centre).length2() > far * far)
            return false;
        const float d2 = triangles_[static_cast<std::size_t>(t)].distance2(p);
        if (!(d2 < distance_[at] * distance_[at]))
            return false;
        distance_[at] = std::sqrt(d2);
        nearest_[at] = t;
        return true;
    }

    void mark_near(const Mesh& mesh, std::uint32_t t) {
        Box3 box;
        for (const std::uint32_t v : mesh.triangles[t])
            box.extendBy(mesh.positions[v]);
        std::array<int, 3> low{}, high{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = std::size_t(axis);
            const auto cell = [&](float x) {
                return (double(x) - grid_.corner[axis]) / grid_.side - 0.5;
            };
            low[a] = std::max(0, static_cast<int>(std::floor(cell(box.min[axis]))));
            high[a] =
                std::min(grid_.count[a] - 1, static_cast<int>(std::ceil(cell(box.max[axis]))));
        }
        for (int k = low[2]; k <= high[2]; ++k)
            for (int j = low[1]; j <= high[1]; ++j)
                for (int i = low[0]; i <= high[0]; ++i)
                    try_triangle(grid_.index(i, j, k), position(i, j, k),
                                 static_cast<std::int32_t>(t));
    }

    // In buckets of a quarter of a step, within which order matters little.
    void spread() {
        std::vector<std::vector<std::uint32_t>> buckets;
        const auto wait = [&](std::size_t at, std::size_t earliest) {
            const std::size_t bucket =
                std::max(earliest, static_cast<std::size_t>(4 * distance_[at] / step_));
            if (bucket >= buckets.size())
                buckets.resize(bucket + 1);
            buckets[bucket].push_back(static_cast<std::uint32_t>(at));
        };
        for (std::size_t at = 0; at < nearest_.size(); ++at)
            if (nearest_[at] != none)
                wait(at, 0);
        std::vector<char> done(nearest_.size(), 0);
        for (std::size_t b = 0; b < buckets.size(); ++b)
            for (std::size_t n = 0; n < buckets[b].size(); ++n) {
                const std::size_t at = buckets[b][n];
                if (done[at])
                    continue;
                done[at] = 1;
                each_beside(at, [&](std::size_t to, const std::array<int, 3>& cell) {
                    if (!done[to] && nearest_[to] != nearest_[at] &&
                        distance_[at] - step_ < distance_[to] &&
                        try_triangle(to, position(cell[0], cell[1], cell[2]), nearest_[at]))
                        wait(to, b);
                });
            }
    }

    // Calls found(sample, its cell) for the six around.
    template <class Found>
    void each_beside(std::size_t at, const Found& found) const {
        const auto layer = static_cast<std::uint32_t>(stride_[2]);
        const auto row = static_cast<std::uint32_t>(stride_[1]);
        const std::uint32_t k = static_cast<std::uint32_t>(at) / layer;
        const std::uint32_t in_layer = static_cast<std::uint32_t>(at) - k * layer;
        const std::uint32_t j = in_layer / row;
        std::array<int, 3> cell{static_cast<int>(in_layer - j * row), static_cast<int>(j),
                                static_cast<int>(k)};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int middle = cell[axis];
            if ((cell[axis] = middle - 1) >= 0)
                found(at - stride_[axis], cell);
            if ((cell[axis] = middle + 1) < grid_.count[axis])
                found(at + stride_[axis], cell);
            cell[axis] = middle;
        }
    }

    VoxelGrid grid_;
    std::vector<DistanceTriangle> triangles_;
    std::vector<Ball> hulls_; // round them
    std::array<std::size_t, 3> stride_;
    float step_;
    std::vector<float> distance_;
    std::vector<std::int32_t> nearest_;
};

} // namespace

SignedDistanceGrid::SignedDistanceGrid(const Mesh& mesh, double step, double thickness,
                                       std::size_t most, double margin)
    : grid_(grid_round(mesh, step, thickness, most, margin)), first_(Vec3(grid_.centre(0, 0, 0))),
      inverse_step_(static_cast<float>(1 / grid_.side)), values_(grid_.size()) {
    stride_ = {1, std::size_t(grid_.count[0]),
               std::size_t(grid_.count[0]) * std::size_t(grid_.count[1])};
    for (int axis = 0; axis < 3; ++axis)
        last_[axis] = static_cast<float>(grid_.count[std::size_t(axis)] - 1);
    const NearestTriangles nearest(mesh, grid_);
    const std::vector<std::uint8_t> inside =
        thickness > 0 ? std::vector<std::uint8_t>() : voxels_inside(mesh, grid_);
    for (std::size_t i = 0; i < values_.size(); ++i) {
        const float distance = nearest.distance(i);
        values_[i] = thickness > 0 ? distance - static_cast<float>(thickness / 2)
                     : inside[i]   ? -distance
                                   : distance;
    }
}

float SignedDistanceGrid::at(const Vec3& p, Vec3& gradient) const {
    const float h = 0.5F / inverse_step_;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 low = p;
        Vec3 high = p;
        low[axis] -= h;
        high[axis] += h;
        gradient[axis] = (at(high) - at(low)) * inverse_step_;
    }
    return at(p);
}

} // namespace scree
