// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/elements/class_sizes.h"

#include "geometry/sampling/poisson_disk.h"

#include <algorithm>
#include <cmath>

namespace scree {

std::vector<double> class_sizes(const std::vector<double>& least,
                                const std::vector<double>& weights) {
    const std::size_t count = weights.size();
    std::vector<double> sizes(count);
    for (std::size_t i = 0; i < count; ++i)
        sizes[i] = 1 / std::sqrt(weights[i]);
    // The matrix grows as its diagonal does.
    const std::vector<double> matrix = class_distances(sizes);
    double factor = 0;
    for (std::size_t i = 0; i < least.size(); ++i)
        factor = std::max(factor, least[i] / matrix[i]);
    for (double& size : sizes)
        size *= factor;
    return sizes;
}

} // namespace scree
