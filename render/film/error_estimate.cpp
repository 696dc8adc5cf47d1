// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/film/error_estimate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace scree {

namespace {

constexpr double mid_grey = 0.18;
constexpr double unknown = std::numeric_limits<double>::infinity();

// The exponent is that of independent samples at least, and that of smooth functions of one
// dimension at most.
constexpr double least_exponent = 1;
constexpr double largest_exponent = 3;
constexpr double fewest_samples = 8; // halves of halves of fewer say nothing

// p where V(n/2) - V(n) is `share` of S / n: n^(1 - p) (2^p - 1) = share, which falls with p.
double exponent(double share, double n) {
    double low = least_exponent;
    double high = largest_exponent;
    for (int i = 0; i < 40; ++i) {
        const double p = (low + high) / 2;
        (std::pow(n, 1 - p) * (std::exp2(p) - 1) > share ? low : high) = p;
    }
    return low;
}

// A pixel's own luminance is high where its error is: the rare bright samples make both. So that
// they do not hide, its luminance is taken to be that of its neighbours.
double luminance_about(const Film& film, int x, int y, int x0, int y0, int x1, int y1) {
    double sum = 0;
    int count = 0;
    for (int v = std::max(y - 1, y0); v < std::min(y + 2, y1); ++v)
        for (int u = std::max(x - 1, x0); u < std::min(x + 2, x1); ++u)
            if (u != x || v != y) {
                sum += film.luminance_at(u, v);
                ++count;
            }
    return count > 0 ? sum / count : film.luminance_at(x, y);
}

} // namespace

void ErrorEstimate::add(const Film& film, int x0, int y0, int x1, int y1) {
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            if (film.samples(x, y) < 2) {
                unknown_ = true;
                return;
            }
            const Film::Differences apart = film.differences(x, y);
            const double scale = luminance_about(film, x, y, x0, y0, x1, y1) + mid_grey;
            const double square = scale * scale;
            const double n = film.samples(x, y);
            const double first = std::bit_floor(film.samples(x, y) - 1);
            const double variance = film.luminance_variance(x, y) / square;
            samples_ += variance;
            first_ += variance * n / first;
            halves_ += apart.halves / square;
            quarters_ += apart.quarters / square;
            log_count_ += std::log(n);
            log_first_ += std::log(first);
            pixels_ += 1;
        }
}

double ErrorEstimate::independent() const {
    return unknown_ || pixels_ == 0 ? unknown : std::sqrt(samples_ / pixels_);
}

double ErrorEstimate::value() const {
    const double n = pixels_ > 0 ? std::exp(log_count_ / pixels_) : 0;
    if (n < fewest_samples || !(samples_ > 0))
        return independent();
    const double of_halves = exponent(halves_ / samples_, n);
    const double of_quarters = exponent(quarters_ / first_, std::exp(log_first_ / pixels_));
    const double p = (of_halves + of_quarters) / 2;
    return independent() * std::pow(n, (1 - p) / 2);
}

} // namespace scree
