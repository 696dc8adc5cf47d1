// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace scree {

/// Where `cost` is least in [low, high], by `iterations` steps of golden-section search (Kiefer
/// 1953): the best of all points tried, both ends included. Of several minima it finds one.
template <class Cost>
double golden_section(const Cost& cost, double low, double high, int iterations) {
    constexpr double share = 1 / std::numbers::phi;
    double best = low;
    double least = cost(low);
    const auto try_at = [&](double t) {
        const double c = cost(t);
        if (c < least) {
            least = c;
            best = t;
        }
        return c;
    };
    try_at(high);
    double left = high - share * (high - low);
    double right = low + share * (high - low);
    double left_cost = try_at(left);
    double right_cost = try_at(right);
    for (int i = 0; i < iterations; ++i) {
        if (left_cost <= right_cost) {
            high = right;
            right = left;
            right_cost = left_cost;
            left = high - share * (high - low);
            left_cost = try_at(left);
        } else {
            low = left;
            left = right;
            left_cost = right_cost;
            right = low + share * (high - low);
            right_cost = try_at(right);
        }
    }
    return best;
}

} // namespace scree
