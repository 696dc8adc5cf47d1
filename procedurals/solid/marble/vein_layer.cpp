// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/marble/vein_layer.h"

#include "procedurals/solid/solid_specs.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree {

namespace {

using solid::Vein;
using solid::VeinLayer;

/// The sum of the veins at z, at most 1.
double veins_sum(const VeinLayer& layer, double z) {
    double sum = 0;
    for (int i = 0; i < layer.veins; ++i) {
        const Vein& vein = layer.vein[i];
        const double period = double(layer.period);
        double x = z - double(vein.centre);
        if (period > 0)
            x -= period * std::round(x / period);
        const double edge = std::abs(x) - double(vein.half_width);
        sum += edge <= 0 ? 1 : std::exp(-double(vein.rate) * edge);
    }
    return std::min(1.0, sum);
}

/// Sets the table's range: one period, or all veins with their tails, with margins for filters on
/// both sides.
void place_table(VeinLayer& layer) {
    layer.start_of_table = 0;
    layer.length = layer.period;
    if (layer.period > 0 || layer.veins == 0)
        return;
    float low = layer.vein[0].centre, high = low;
    for (int i = 0; i < layer.veins; ++i) {
        const Vein& vein = layer.vein[i];
        const float reach = vein.half_width + 12 / vein.rate; // exp(-12) is negligible
        low = std::min(low, vein.centre - reach);
        high = std::max(high, vein.centre + reach);
    }
    layer.start_of_table = low - (high - low);
    layer.length = 3 * (high - low);
}

/// Convolves the sum with Gaussians numerically. There is a closed form for a single vein, but the
/// sum is clamped to 1 before filtering.
void make_table(VeinLayer& layer) {
    std::vector<double> fine(PROFILE_POINTS);
    double sum = 0;
    for (int i = 0; i < PROFILE_POINTS; ++i) {
        const double z = double(layer.start_of_table) + double(layer.length) * i / PROFILE_POINTS;
        const double value = veins_sum(layer, z);
        fine[static_cast<std::size_t>(i)] = value;
        layer.table[i] = as_float(value);
        sum += value;
    }
    layer.mean = as_float(sum / PROFILE_POINTS);
    float* out = layer.table + PROFILE_POINTS;
    for (int level = 0; level < PROFILE_LEVELS; ++level) {
        const int stride = 1 << level;
        const double sigma = double(PROFILE_FINEST) * stride; // in points of the unfiltered profile
        const int reach = static_cast<int>(5 * sigma);
        for (int i = 0; i < PROFILE_POINTS; i += stride) {
            double mean = 0, weights = 0;
            for (int k = -reach; k <= reach; ++k) {
                const double weight = std::exp(-0.5 * (k / sigma) * (k / sigma));
                const auto at = static_cast<std::size_t>((i + k) & (PROFILE_POINTS - 1));
                mean += weight * fine[at];
                weights += weight;
            }
            *out++ = as_float(mean / weights);
        }
    }
}

} // namespace

void scatter_veins(VeinLayer& layer, const MarbleVeins& veins, double size, Random& random) {
    layer.period = as_float(size);
    layer.veins = veins.count;
    for (int i = 0; i < veins.count; ++i) {
        // Stratified positions, which avoid clusters and large gaps; widths are log-uniform over a
        // factor of 9.
        Vein& vein = layer.vein[i];
        vein.centre = as_float((i + random.uniform(0.1, 0.9)) / veins.count * size);
        vein.half_width = as_float(veins.width * size * std::pow(3, random.uniform(-1, 1)) / 2);
        vein.rate = as_float(1 / (veins.diffusion * size * random.uniform(0.6, 1.4)));
    }
}

void list_veins(VeinLayer& layer, const Params& params, const MarbleVeins& defaults) {
    const std::vector<Params>& veins = params.list("veins");
    if (veins.size() > MARBLE_MAX_VEINS)
        throw params.error("veins", "has more than 32 veins");
    const double size = params.number("size");
    for (const Params& given : veins) {
        Vein& vein = layer.vein[layer.veins++];
        vein.centre = as_float(given.number("at"));
        vein.half_width = as_float(number_or(given, "width", defaults.width * size) / 2);
        vein.rate = as_float(1 / number_or(given, "diffusion", defaults.diffusion * size));
    }
}

void tabulate(VeinLayer& layer) {
    place_table(layer);
    make_table(layer);
}

} // namespace scree
