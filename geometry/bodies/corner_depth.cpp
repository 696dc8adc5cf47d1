// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/corner_depth.h"

#include "core/parallel.h"

namespace scree {

namespace {

constexpr double most_cells = 1 << 18;

BallTree tree_of(const std::vector<Vec3>& points) {
    std::vector<Ball> balls;
    balls.reserve(points.size());
    for (const Vec3& p : points)
        balls.push_back({p, 0});
    return BallTree(std::move(balls));
}

VoxelGrid grid_of(const std::vector<Vec3>& points, double step, double margin) {
    Box3 box;
    for (const Vec3& p : points)
        box.extendBy(p);
    const Imath::V3d size = Imath::V3d(box.size()) + Imath::V3d(2 * margin);
    VoxelGrid grid;
    grid.side = std::max(step, std::cbrt(size.x * size.y * size.z / most_cells));
    for (int axis = 0; axis < 3; ++axis)
        grid.count[std::size_t(axis)] = static_cast<int>(std::ceil(size[axis] / grid.side)) + 1;
    grid.corner = Imath::V3d(box.min) - Imath::V3d(margin + grid.side / 2);
    return grid;
}

} // namespace

CornerDepth::CornerDepth(const std::vector<Vec3>& corners, double step, double largest)
    : corners_(tree_of(corners)), grid_(grid_of(corners, step, largest)), low_(grid_.corner),
      step_(static_cast<float>(grid_.side)), inverse_step_(static_cast<float>(1 / grid_.side)),
      distance_(grid_.size()) {
    for (int axis = 0; axis < 3; ++axis)
        high_[axis] = static_cast<float>(grid_.count[std::size_t(axis)]);
    const auto rows = std::size_t(grid_.count[1]) * std::size_t(grid_.count[2]);
    parallel_for(rows, 4, [&](std::size_t row) {
        const auto j = static_cast<int>(row % std::size_t(grid_.count[1]));
        const auto k = static_cast<int>(row / std::size_t(grid_.count[1]));
        float nearest = std::numeric_limits<float>::max();
        for (int i = 0; i < grid_.count[0]; ++i) {
            // The nearest corner is at most a step farther than from the cell before.
            const float floor = -nearest - 1.001F * step_;
            nearest = -depth({Vec3(grid_.centre(i, j, k)), 0}, floor);
            distance_[grid_.index(i, j, k)] = nearest;
        }
    });
}

} // namespace scree
