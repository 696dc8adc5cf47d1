// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/poisson_disk.h"

#include <algorithm>
#include <numeric>

namespace scree {

std::vector<double> class_distances(const std::vector<double>& distances, int dimension) {
    const std::size_t n = distances.size();
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distances[a] > distances[b]; });
    std::vector<double> matrix(n * n);
    double density = 0; // of the samples of all groups so far, in units of 1 / distance^dimension
    for (std::size_t from = 0, to = 0; from < n; from = to) {
        while (to < n && distances[order[to]] == distances[order[from]])
            density += std::pow(distances[order[to++]], -dimension);
        const double between = std::pow(density, -1.0 / dimension);
        for (std::size_t a = from; a < to; ++a)
            for (std::size_t b = 0; b < to; ++b)
                if (a != b)
                    matrix[order[a] * n + order[b]] = matrix[order[b] * n + order[a]] = between;
    }
    for (std::size_t i = 0; i < n; ++i)
        matrix[i * n + i] = distances[i];
    return matrix;
}

} // namespace scree
