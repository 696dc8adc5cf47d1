// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/filter.h"

#include <algorithm>

namespace scree {

namespace {

// With 1024 quantiles the largest error of the sampled density is below that of a chi-square test
// over a million samples (tests/unit/render_filter_test.cpp).
constexpr int quantile_count = 1024;
constexpr int integration_steps = 1 << 16;

} // namespace

float filter_value(Filter filter, float radius, float x) {
    const float distance = std::abs(x) / radius;
    if (distance > 1)
        return 0;
    switch (filter) {
    case Filter::box:
        return 1;
    case Filter::triangle:
        return 1 - distance;
    case Filter::gaussian:
        return std::exp(-0.5F * 9 * distance * distance);
    case Filter::blackman_harris: { // Harris 1978, minimum 4-term window
        const float phase = static_cast<float>(pi) * (1 + distance);
        return 0.35875F - 0.48829F * std::cos(phase) + 0.14128F * std::cos(2 * phase) -
               0.01168F * std::cos(3 * phase);
    }
    }
    return 0;
}

FilterSampler::FilterSampler(Filter filter, float radius) {
    const double step = 2.0 * double(radius) / integration_steps;
    std::vector<double> integral(integration_steps + 1, 0.0);
    for (int i = 0; i < integration_steps; ++i) {
        const double x = -double(radius) + (i + 0.5) * step;
        integral[std::size_t(i) + 1] =
            integral[std::size_t(i)] +
            std::max(0.0, double(filter_value(filter, radius, static_cast<float>(x))));
    }
    quantiles_.resize(quantile_count + 1);
    std::size_t i = 0;
    for (int q = 0; q <= quantile_count; ++q) {
        const double target = integral.back() * q / quantile_count;
        while (i + 1 < integration_steps && integral[i + 1] < target)
            ++i;
        const double width = integral[i + 1] - integral[i];
        const double part = width > 0 ? std::clamp((target - integral[i]) / width, 0.0, 1.0) : 0;
        quantiles_[std::size_t(q)] =
            static_cast<float>(-double(radius) + (double(i) + part) * step);
    }
}

float FilterSampler::inverse(float u) const {
    const float position = u * quantile_count;
    const auto cell = static_cast<std::size_t>(position);
    const float part = position - static_cast<float>(cell);
    return quantiles_[cell] + (quantiles_[cell + 1] - quantiles_[cell]) * part;
}

} // namespace scree
