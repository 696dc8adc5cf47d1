// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/exact/climb.h"

#include "core/math.h"

#include <algorithm>
#include <vector>

namespace scree::tests {

namespace {

using Function = std::function<double(const Place&)>;

double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Place along(const Place& from, const Place& direction, double length) {
    return {from[0] + length * direction[0], from[1] + length * direction[1],
            from[2] + length * direction[2]};
}

Place gradient(const Function& value, const Place& at, double step) {
    Place out{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Place up = at;
        Place down = at;
        up[axis] += step;
        down[axis] -= step;
        out[axis] = (value(up) - value(down)) / (2 * step);
    }
    return out;
}

/// Approximately the shortest vector in the convex hull of the gradients (Gilbert 1966).
Place shortest(const std::vector<Place>& gradients) {
    Place best = gradients[0];
    for (int i = 0; i < 60; ++i) {
        const Place lowest =
            *std::ranges::min_element(gradients, {}, [&](const Place& g) { return dot(best, g); });
        const Place way = along(lowest, best, -1);
        const double squared = dot(way, way);
        if (squared == 0)
            break;
        best = along(best, way, std::clamp(-dot(best, way) / squared, 0.0, 1.0));
    }
    return best;
}

} // namespace

Place climb(const Function& value, Place start, double enough, Random& random) {
    constexpr double finest = 1e-9;
    double height = value(start);
    for (double radius = 0.05; radius > finest && height < enough;) {
        std::vector<Place> gradients{gradient(value, start, radius / 100)};
        for (int i = 0; i < 6; ++i) {
            Place near = start;
            for (double& x : near)
                x += radius * random.uniform(-1, 1);
            gradients.push_back(gradient(value, near, radius / 100));
        }
        Place direction = shortest(gradients);
        const double length = std::sqrt(dot(direction, direction));
        bool better = false;
        for (double step = 4 * radius; step > 0.1 * radius && !better && length > 1e-6; step /= 2) {
            const Place next = along(start, direction, step / length);
            const double there = value(next);
            better = there > height;
            if (better) {
                start = next;
                height = there;
            }
        }
        if (!better)
            radius /= 3;
    }
    return start;
}

} // namespace scree::tests
