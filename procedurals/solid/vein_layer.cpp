// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/vein_layer.h"

#include "procedurals/solid/solid_specs.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree {

namespace {

using solid::Vein;
using solid::VeinLayer;

/// Distance from a vein's middle, of its nearest image.
double from_middle(const VeinLayer& layer, const Vein& vein, double z) {
    const double x = z - double(vein.centre), period = double(layer.period);
    return std::abs(period > 0 ? x - period * std::round(x / period) : x);
}

/// The veins' sum at z, not limited to 1, and which of them gives most.
struct Sum {
    double value = 0;
    int largest = 0;
};
Sum veins_sum(const VeinLayer& layer, double z) {
    Sum sum;
    double nearest = 0;
    for (int i = 0; i < layer.veins; ++i) {
        const Vein& vein = layer.vein[i];
        const double edge = from_middle(layer, vein, z) - double(vein.half_width);
        sum.value += edge <= 0 ? 1 : std::exp(-double(vein.rate) * edge);
        if (i == 0 || edge < nearest) {
            nearest = edge;
            sum.largest = i;
        }
    }
    return sum;
}

/// Fills the table from the sum itself: cut off at 1, which the closed form of a vein knows nothing
/// of, and then averaged.
void make_table(VeinLayer& layer) {
    std::vector<double> fine(PROFILE_POINTS);
    double sum = 0;
    for (int i = 0; i < PROFILE_POINTS; ++i) {
        const double z = double(layer.period) * i / PROFILE_POINTS;
        fine[static_cast<std::size_t>(i)] = std::min(1.0, veins_sum(layer, z).value);
        layer.table[i] = as_float(fine[static_cast<std::size_t>(i)]);
        sum += fine[static_cast<std::size_t>(i)];
    }
    layer.mean = as_float(sum / PROFILE_POINTS);
    float* out = layer.table + PROFILE_POINTS;
    for (int level = 0; level < PROFILE_LEVELS; ++level) {
        const int stride = 1 << level;
        const double sigma = double(PROFILE_FINEST) * stride; // in fine points
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
        // One in each of equal strata, so that they neither crowd nor leave bare stone; widths are
        // log-uniform over a factor of 9.
        Vein& vein = layer.vein[i];
        vein.centre = as_float((i + random.uniform(0.1, 0.9)) / veins.count * size);
        vein.half_width = as_float(veins.width * size * std::pow(3, random.uniform(-1, 1)) / 2);
        vein.rate = as_float(1 / (veins.diffusion * size * random.uniform(0.6, 1.4)));
    }
}

void list_veins(VeinLayer& layer, const Params& params, const MarbleVeins& defaults) {
    const std::vector<Params>& veins = params.list("veins");
    if (veins.size() > MARBLE_MOST_VEINS)
        throw params.error("veins", "has more than 32 veins");
    const double size = params.number("size");
    for (const Params& given : veins) {
        Vein& vein = layer.vein[layer.veins++];
        vein.centre = as_float(given.number("at"));
        vein.half_width = as_float(number_or(given, "width", defaults.width * size) / 2);
        vein.rate = as_float(1 / number_or(given, "diffusion", defaults.diffusion * size));
    }
}

void measure_profile(VeinLayer& layer) {
    constexpr int points = 512;
    for (int i = 0; i < layer.veins; ++i) {
        // A sum above 1 lies about its largest vein; where that is down to 1 / n of n veins it
        // ends.
        Vein& vein = layer.vein[i];
        const double reach =
            double(vein.half_width) + std::log(std::max(2, layer.veins)) / double(vein.rate);
        int above = 0;
        double excess = 0;
        for (int k = 0; k < points; ++k) {
            const double x = reach * ((2 * k + 1.0) / points - 1);
            const Sum sum = veins_sum(layer, double(vein.centre) + x);
            if (sum.value > 1 && sum.largest == i) {
                ++above;
                excess += sum.value - 1;
            }
        }
        vein.excess = above > 0 ? as_float(excess / above) : 0;
        vein.excess_half_width = as_float(reach * above / points);
    }
    if (layer.period > 0)
        make_table(layer);
}

} // namespace scree
