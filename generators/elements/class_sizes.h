// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace scree {

/// Distances for several classes of elements that are mixed evenly: r_i in proportion to
/// share_i^(-1/2), so that the classes' counts have the weights' shares (Wei 2010, section 3.2),
/// and as small as lets every r(i, j) of their matrix be at least `least[i * n + j]` [m]. Weights
/// are above 0.
std::vector<double> class_sizes(const std::vector<double>& least,
                                const std::vector<double>& weights);

} // namespace scree
