// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/rock_sizes.h"

#include "core/math.h"
#include "core/random.h"

#include <algorithm>

namespace scree::rocks {

namespace {

/// A number in each of `count` equal parts of [0, 1].
double stratified(std::size_t i, std::size_t count, std::uint64_t seed) {
    Random random(seed, Purpose::rock_size, i);
    return (double(i) + random.uniform()) / double(count);
}

/// The number of rocks longer than D that Golombek & Rapp's areas mean, tabulated.
class AreaCounts {
  public:
    AreaCounts(double k, double smallest, double largest, double area, double fill)
        : smallest_(smallest), ratio_(largest / smallest) {
        const double q = 1.79 + 0.152 / k;
        const auto density = [&](double d) { // rocks for a metre of D
            return area * k * q * std::exp(-q * d) / (fill * d * d);
        };
        for (int i = 1; i <= steps; ++i) { // trapezoids in ln D
            const double low = size_at(double(i - 1) / steps);
            const double high = size_at(double(i) / steps);
            const double width = std::log(high / low);
            shorter_[std::size_t(i)] = shorter_[std::size_t(i) - 1] +
                                       (density(low) * low + density(high) * high) * width / 2;
        }
    }

    double count() const { return shorter_.back(); }

    double size_of_quantile(double u) const {
        const double wanted = u * count();
        const auto above = std::upper_bound(shorter_.begin() + 1, shorter_.end() - 1, wanted);
        const auto i = std::size_t(above - shorter_.begin());
        const double within = (wanted - shorter_[i - 1]) / (shorter_[i] - shorter_[i - 1]);
        return size_at((double(i - 1) + within) / steps);
    }

  private:
    static constexpr int steps = 4096;

    double size_at(double t) const { return smallest_ * std::pow(ratio_, t); }

    double smallest_;
    double ratio_;
    std::vector<double> shorter_ = std::vector<double>(steps + 1, 0.0);
};

} // namespace

double cell_area(const SizeClass& size) {
    return pi * 0.25 * size.radius * size.radius / disk_fill;
}

std::vector<double> power_sizes(double smallest, double largest, double exponent, std::size_t count,
                                std::uint64_t seed) {
    const double most = std::pow(smallest, -exponent);
    const double least = std::pow(largest, -exponent);
    std::vector<double> sizes(count);
    for (std::size_t i = 0; i < count; ++i)
        sizes[i] = std::pow(std::lerp(least, most, stratified(i, count, seed)), -1 / exponent);
    return sizes;
}

double power_mean_square(double smallest, double largest, double exponent) {
    const double q = exponent;
    const double norm = std::pow(smallest, -q) - std::pow(largest, -q);
    if (std::abs(q - 2) < 1e-9)
        return 2 * std::log(largest / smallest) / norm;
    return q / (q - 2) * (std::pow(smallest, 2 - q) - std::pow(largest, 2 - q)) / norm;
}

std::vector<double> area_sizes(double k, double smallest, double largest, double area, double fill,
                               std::uint64_t seed) {
    const AreaCounts counts(k, smallest, largest, area, fill);
    const auto count = static_cast<std::size_t>(std::lround(counts.count()));
    std::vector<double> sizes(count);
    for (std::size_t i = 0; i < count; ++i)
        sizes[i] = counts.size_of_quantile(stratified(i, count, seed));
    std::reverse(sizes.begin(), sizes.end());
    return sizes;
}

double area_count(double k, double smallest, double largest, double area, double fill) {
    return AreaCounts(k, smallest, largest, area, fill).count();
}

std::vector<double> class_sizes(std::span<const SizeClass> classes, double cover, double area,
                                double fill, std::uint64_t seed) {
    std::vector<double> sizes;
    for (std::size_t c = 0; c < classes.size(); ++c) {
        const double usual = std::sqrt(4 / pi * cell_area(classes[c]));
        const double wanted = classes[c].share * cover * area;
        const auto count =
            std::max<std::size_t>(1, std::size_t(std::lround(wanted / (fill * usual * usual))));
        for (std::size_t i = 0; i < count; ++i)
            sizes.push_back(
                usual *
                std::sqrt(0.7 +
                          0.6 * stratified(i, count, derived_seed(seed, Purpose::rock_size, c))));
    }
    std::sort(sizes.begin(), sizes.end(), std::greater<>());
    return sizes;
}

} // namespace scree::rocks
