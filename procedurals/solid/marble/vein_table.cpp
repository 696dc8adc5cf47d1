// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/marble/vein_table.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace scree {

namespace {

constexpr double nothing = 17; // exp(-17) = 4e-8 is negligible
constexpr double most_bins = 1 << 16;
// Tolerance of a fit. A cubic over 1/5 of a vein's diffusion length has an error of at most 5e-7.
constexpr double tolerance = 1e-6, steepest = 0.2;
// Bins per edge: bins with an edge are slower, so only a few points should lie in them.
constexpr double bins_an_edge = 1024;
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

/// The interpolation polynomial (Newton's divided differences), lowest power first.
template <std::size_t count>
std::array<double, count> through(const std::array<double, count>& at,
                                  std::array<double, count> values) {
    for (std::size_t order = 1; order < count; ++order)
        for (std::size_t i = count - 1; i >= order; --i)
            values[i] = (values[i] - values[i - 1]) / (at[i] - at[i - order]);
    std::array<double, count> powers{};
    for (std::size_t i = count; i-- > 0;) { // powers * (x - at) + value
        for (std::size_t k = count - 1; k > 0; --k)
            powers[k] = powers[k - 1] - at[i] * powers[k];
        powers[0] = values[i] - at[i] * powers[0];
    }
    return powers;
}

/// Chebyshev nodes of an interval.
template <std::size_t count>
std::array<double, count> nodes(double first, double last) {
    std::array<double, count> found{};
    for (std::size_t i = 0; i < count; ++i)
        found[i] = first +
                   (last - first) *
                       (0.5 - 0.5 * std::cos(std::numbers::pi * (double(i) + 0.5) / double(count)));
    return found;
}

} // namespace

VeinTable::VeinTable(std::span<const solid::Vein> veins, float period)
    : veins_(veins.begin(), veins.end()), period_(period) {
    for (solid::Vein& vein : veins_)
        vein.rate = std::clamp(vein.rate, 1e-6F, 1e20F) * std::numbers::log2e_v<float>;
    bins_.resize(choose_bins());
    fit_bins();
}

std::size_t VeinTable::choose_bins() {
    if (veins_.empty())
        return 1;
    double low = 1e30, high = -1e30, rate = 0;
    for (const solid::Vein& vein : veins_) {
        const double natural = double(vein.rate) * std::numbers::ln2;
        const double reach = double(vein.half_width) + nothing / natural;
        low = std::min(low, double(vein.centre) - reach);
        high = std::max(high, double(vein.centre) + reach);
        rate = std::max(rate, natural);
    }
    const double range = period_ > 0 ? double(period_) : high - low;
    const double wanted = std::min(
        std::max(range * rate / steepest, bins_an_edge * 2 * double(veins_.size())), most_bins);
    if (period_ > 0) {
        const auto count = std::bit_ceil(static_cast<std::size_t>(wanted));
        scale_ = static_cast<float>(count) / period_;
        return count;
    }
    // Scaling by a power of 2 is exact.
    scale_ = static_cast<float>(std::exp2(std::floor(std::log2(wanted / range))));
    first_ = static_cast<float>(low);
    last_ = static_cast<float>(high);
    return std::bit_ceil(static_cast<std::size_t>(range * double(scale_)) + 3);
}

VeinTable::Bin& VeinTable::bin(std::int64_t number) {
    return bins_[static_cast<std::size_t>(number) & (bins_.size() - 1)];
}

double VeinTable::sum(double z) const {
    double found = 0;
    for (const solid::Vein& vein : veins_) {
        double away = z - double(vein.centre);
        if (period_ > 0)
            away -= double(period_) * std::round(away / double(period_));
        const double outwards = (std::abs(away) - double(vein.half_width)) * double(vein.rate);
        if (outwards < nothing * std::numbers::log2e)
            found += outwards > 0 ? std::exp2(-outwards) : 1;
    }
    return found;
}

// For each bin, the places where the slope of the sum is discontinuous.
std::vector<std::vector<double>> VeinTable::find_kinks() const {
    std::vector<std::vector<double>> found(bins_.size());
    const auto add = [&](double z) {
        const double at = z * double(scale_), number = std::round(at);
        found[static_cast<std::size_t>(static_cast<std::int64_t>(number)) & (bins_.size() - 1)]
            .push_back(at - number);
    };
    for (const solid::Vein& vein : veins_) {
        add(double(vein.centre) - double(vein.half_width));
        add(double(vein.centre) + double(vein.half_width));
        if (period_ > 0) // half-way between periodic images
            add(double(vein.centre) + double(period_) / 2);
    }
    return found;
}

void VeinTable::fit_bins() {
    const Bin unfit{no_number, 0, 0, 0};
    divided_.push_back({unfit, unfit, 0});
    const std::vector<std::vector<double>> kinks = find_kinks();
    const auto start = static_cast<std::int64_t>(std::lround(first_ * scale_));
    for (std::int64_t i = start; i < start + static_cast<std::int64_t>(bins_.size()); ++i) {
        Bin& made = bin(i);
        const auto& borders = kinks[static_cast<std::size_t>(&made - bins_.data())];
        made = borders.empty() ? fit(i, -0.5, 0.5) : unfit;
        if (!std::isnan(made.powers[0]))
            continue;
        std::size_t number = 0;
        if (borders.size() <= 1) {
            const double border = borders.empty() ? 0 : borders.front();
            number = divided_.size();
            divided_.push_back(
                {fit(i, -0.5, border), fit(i, border, 0.5), static_cast<float>(border)});
        }
        made = {no_number, 0x1p23F + static_cast<float>(number), 0, 0};
    }
}

VeinTable::Bin VeinTable::fit(std::int64_t number, double first, double last) const {
    const auto value = [&](double at) { return sum((double(number) + at) / double(scale_)); };
    const auto at = nodes<4>(first, last);
    std::array<double, 4> values{};
    std::ranges::transform(at, values.begin(), value);
    const auto powers = through(at, values);
    Bin found{};
    std::ranges::transform(powers, found.powers, [](double v) { return static_cast<float>(v); });
    for (const double part : {0.0, 0.15, 0.5, 0.85, 1.0}) {
        const double tried = first + (last - first) * part;
        const double fitted =
            powers[0] + tried * (powers[1] + tried * (powers[2] + tried * powers[3]));
        if (!(std::abs(fitted - value(tried)) < tolerance))
            found.powers[0] = no_number;
    }
    return found;
}

} // namespace scree
