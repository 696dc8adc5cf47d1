// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/voxel_grid.h"

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/mesh/line_crossing.h"

#include <algorithm>
#include <tuple>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

/// Where a line along z crosses the surface.
struct Crossing {
    int column;
    LineCrossing at;
};

// The first cell whose centre is not below `at`, in [0, count].
int cell_from(double at, int count) {
    return static_cast<int>(std::clamp(std::ceil(at - 0.5), 0.0, double(count)));
}

} // namespace

VoxelGrid voxel_grid(const Mesh& mesh, int longest) {
    const Box3 box = bounds(mesh);
    const Vec3d extent(box.size());
    const double most = std::max({extent.x, extent.y, extent.z});
    if (mesh.positions.empty() || !(most > 0))
        throw Error("has no extent");
    VoxelGrid grid;
    grid.side = most / longest;
    Vec3d covered;
    for (int axis = 0; axis < 3; ++axis) {
        // A side of a whole number of cubes must not get one more by rounding.
        const double cubes = std::ceil(extent[axis] / grid.side - 1e-4);
        grid.count[std::size_t(axis)] = std::clamp(static_cast<int>(cubes), 1, longest);
        covered[axis] = grid.side * grid.count[std::size_t(axis)];
    }
    grid.corner = Vec3d(box.center()) - covered * 0.5;
    return grid;
}

std::vector<std::uint8_t> voxels_inside(const Mesh& mesh, const VoxelGrid& grid) {
    const auto triangle = [&](std::uint32_t t) {
        std::array<Vec3d, 3> v;
        for (std::size_t k = 0; k < 3; ++k)
            v[k] = (Vec3d(mesh.positions[mesh.triangles[t][k]]) - grid.corner) / grid.side;
        return v; // in cells
    };
    std::vector<std::vector<std::uint32_t>> of_row(std::size_t(grid.count[1]));
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::array<Vec3d, 3> v = triangle(t);
        const auto [low, high] = std::minmax({v[0].y, v[1].y, v[2].y});
        // One more: on the line counts too.
        for (int j = cell_from(low, grid.count[1]);
             j < cell_from(std::nextafter(high, high + 1), grid.count[1]); ++j)
            of_row[std::size_t(j)].push_back(t);
    }
    std::vector<std::uint8_t> inside(grid.size(), 0);
    parallel_for(of_row.size(), 1, [&](std::size_t row) {
        const int j = static_cast<int>(row);
        std::vector<Crossing> crossings;
        for (const std::uint32_t t : of_row[row]) {
            const std::array<Vec3d, 3> v = triangle(t);
            const auto [low, high] = std::minmax({v[0].x, v[1].x, v[2].x});
            for (int i = cell_from(low, grid.count[0]);
                 i < cell_from(std::nextafter(high, high + 1), grid.count[0]); ++i)
                if (const auto found = line_crossing(v, {i + 0.5, j + 0.5}))
                    crossings.push_back({i, *found});
        }
        std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
            return std::tie(a.column, a.at.z) < std::tie(b.column, b.at.z);
        });
        int winding = 0;
        for (std::size_t n = 0; n + 1 < crossings.size(); ++n) {
            const Crossing& from = crossings[n];
            const Crossing& to = crossings[n + 1];
            winding += from.at.turn;
            if (to.column != from.column) {
                winding = 0;
                continue;
            }
            for (int k = cell_from(from.at.z, grid.count[2]);
                 winding != 0 && k < cell_from(to.at.z, grid.count[2]); ++k)
                inside[grid.index(from.column, j, k)] = 1;
        }
    });
    return inside;
}

} // namespace scree
