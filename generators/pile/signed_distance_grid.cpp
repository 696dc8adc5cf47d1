// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/signed_distance_grid.h"

#include "generators/pile/triangle_distance.h"

#include <limits>

namespace scree {

namespace {

constexpr std::int32_t none = -1;

// Samples all round the mesh, the outermost outside of it.
VoxelGrid grid_round(const Mesh& mesh, double step, double thickness, std::size_t most) {
    const Box3 box = bounds(mesh);
    const Imath::V3d extent = Imath::V3d(box.size()) + Imath::V3d(thickness);
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

/// The nearest triangle of every sample: exact next to the surface, from there handed on from
/// sample to neighbour (vector distance transform, Danielsson 1980, with triangles for points).
class NearestTriangles {
  public:
    NearestTriangles(const Mesh& mesh, const VoxelGrid& grid)
        : grid_(grid), distance2_(grid.size(), std::numeric_limits<float>::max()),
          nearest_(grid.size(), none) {
        triangles_.reserve(mesh.triangles.size());
        for (const Mesh::Triangle& t : mesh.triangles)
            triangles_.emplace_back(std::array<Vec3, 3>{mesh.positions[t[0]], mesh.positions[t[1]],
                                                        mesh.positions[t[2]]});
        for (std::uint32_t t = 0; t < triangles_.size(); ++t)
            mark_near(mesh, t);
        for (const int dz : {1, -1})
            for (const int dy : {1, -1})
                for (const int dx : {1, -1})
                    sweep({dx, dy, dz});
    }

    float distance(std::size_t i) const { return std::sqrt(distance2_[i]); }

  private:
    Vec3 position(int i, int j, int k) const { return Vec3(grid_.centre(i, j, k)); }

    void try_triangle(std::size_t at, const Vec3& p, std::int32_t t) {
        const float d2 = triangles_[static_cast<std::size_t>(t)].distance2(p);
        if (d2 < distance2_[at]) {
            distance2_[at] = d2;
            nearest_[at] = t;
        }
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

    void sweep(const std::array<int, 3>& d) {
        const std::array<int, 3>& n = grid_.count;
        const auto start = [&](std::size_t axis) { return d[axis] > 0 ? 0 : n[axis] - 1; };
        const auto inside = [&](std::size_t axis, int i) { return i >= 0 && i < n[axis]; };
        for (int k = start(2); inside(2, k); k += d[2])
            for (int j = start(1); inside(1, j); j += d[1])
                for (int i = start(0); inside(0, i); i += d[0])
                    hand_on(i, j, k, d);
    }

    // From the seven samples before this one. A neighbour whose triangle is too far to help is
    // left alone.
    void hand_on(int i, int j, int k, const std::array<int, 3>& d) {
        const std::size_t at = grid_.index(i, j, k);
        const Vec3 p = position(i, j, k);
        for (int bits = 1; bits < 8; ++bits) {
            const int x = i - (bits & 1 ? d[0] : 0);
            const int y = j - (bits & 2 ? d[1] : 0);
            const int z = k - (bits & 4 ? d[2] : 0);
            if (x < 0 || y < 0 || z < 0 || x >= grid_.count[0] || y >= grid_.count[1] ||
                z >= grid_.count[2])
                continue;
            const std::size_t from = grid_.index(x, y, z);
            const std::int32_t t = nearest_[from];
            if (t == none || t == nearest_[at])
                continue;
            const float apart =
                static_cast<float>(grid_.side) * reach_of[static_cast<std::size_t>(bits)];
            if (nearest_[at] != none && distance(from) - apart >= distance(at))
                continue;
            try_triangle(at, p, t);
        }
    }

    static constexpr std::array<float, 8> reach_of{0, 1,        1,        1.41422F,
                                                   1, 1.41422F, 1.41422F, 1.73206F};

    VoxelGrid grid_;
    std::vector<DistanceTriangle> triangles_;
    std::vector<float> distance2_;
    std::vector<std::int32_t> nearest_;
};

} // namespace

SignedDistanceGrid::SignedDistanceGrid(const Mesh& mesh, double step, double thickness,
                                       std::size_t most)
    : grid_(grid_round(mesh, step, thickness, most)), first_(Vec3(grid_.centre(0, 0, 0))),
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

float SignedDistanceGrid::at(const Vec3& p) const {
    const Vec3 g = (p - first_) * inverse_step_;
    const Vec3 c(std::clamp(g.x, 0.0F, last_.x), std::clamp(g.y, 0.0F, last_.y),
                 std::clamp(g.z, 0.0F, last_.z));
    // None is negative, so that truncation is the floor.
    const int x = std::min(static_cast<int>(c.x), grid_.count[0] - 2);
    const int y = std::min(static_cast<int>(c.y), grid_.count[1] - 2);
    const int z = std::min(static_cast<int>(c.z), grid_.count[2] - 2);
    const float u = c.x - static_cast<float>(x);
    const float v = c.y - static_cast<float>(y);
    const float w = c.z - static_cast<float>(z);
    const float* near = values_.data() + static_cast<std::size_t>(x) +
                        static_cast<std::size_t>(y) * stride_[1] +
                        static_cast<std::size_t>(z) * stride_[2];
    const float* far = near + stride_[2];
    const auto along_x = [u](const float* f) { return f[0] + u * (f[1] - f[0]); };
    const auto in_plane = [&](const float* f) {
        const float low = along_x(f);
        return low + v * (along_x(f + stride_[1]) - low);
    };
    const float low = in_plane(near);
    const float inside = low + w * (in_plane(far) - low);
    const float beyond2 = (g - c).length2();
    if (beyond2 == 0)
        return inside;
    // The mesh lies in the grid's box, so that the way to it turns by a right angle or more.
    const auto step = static_cast<float>(grid_.side);
    return std::sqrt(beyond2 * step * step + inside * inside);
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
