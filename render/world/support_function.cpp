// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/world/support_function.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace scree {

namespace {

// The octahedron |x| + |y| + |z| = `side` has a grid point at every place with whole coordinates:
// 146 directions, neighbours 10 to 22 degrees apart. The reach of a ball is overestimated by up to
// 2 %, that of a needle, where it lies across, by up to a fifth of half its length.
constexpr int side = 6;
constexpr int row_length = side + 1;
constexpr std::size_t per_octant = std::size_t{row_length} * row_length;

std::size_t index(int octant, int x, int y) {
    return std::size_t(octant) * per_octant + std::size_t(x * row_length + y);
}

} // namespace

SupportFunction::SupportFunction(std::span<const Vec3> points) {
    if (points.empty())
        return;
    reach_.assign(8 * per_octant, 0);
    struct Direction {
        std::size_t index;
        Vec3 direction;
    };
    std::vector<Direction> directions;
    for (int octant = 0; octant < 8; ++octant)
        for (int x = 0; x <= side; ++x)
            for (int y = 0; x + y <= side; ++y) {
                const auto along = [&](int bit, int length) {
                    return static_cast<float>((octant & bit) != 0 ? -length : length);
                };
                directions.push_back(
                    {index(octant, x, y), {along(1, x), along(2, y), along(4, side - x - y)}});
            }
    parallel_for(directions.size(), 4, [&](std::size_t i) {
        const Vec3 d = directions[i].direction;
        std::array<float, 8> most; // side by side, so that they need no one order
        most.fill(-std::numeric_limits<float>::infinity());
        for (std::size_t k = 0; k < points.size(); ++k)
            most[k % 8] = std::max(most[k % 8], points[k].dot(d));
        reach_[directions[i].index] = *std::ranges::max_element(most);
    });
}

float SupportFunction::operator()(const Vec3& direction) const {
    const float sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
    if (!(sum > 0))
        return 0;
    const int octant =
        (direction.x < 0 ? 1 : 0) | (direction.y < 0 ? 2 : 0) | (direction.z < 0 ? 4 : 0);
    // Coordinates on the octant's triangle, and those within one of its small triangles.
    const float x = std::min(std::abs(direction.x) / sum, 1.0F) * side;
    const float y = std::min(std::abs(direction.y) / sum, 1 - x / side) * side;
    const int column = std::min(static_cast<int>(x), side - 1);
    const int row = std::min(static_cast<int>(y), side - 1 - column);
    const float right = x - static_cast<float>(column), up = y - static_cast<float>(row);
    const auto at = [&](int i, int j) { return reach_[index(octant, column + i, row + j)]; };
    const float reach =
        right + up <= 1 || column + row == side - 1
            ? at(0, 0) * (1 - right - up) + at(1, 0) * right + at(0, 1) * up
            : at(1, 1) * (right + up - 1) + at(1, 0) * (1 - up) + at(0, 1) * (1 - right);
    return reach * sum / side;
}

} // namespace scree
