// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/gaps.h"

#include "core/parallel.h"
#include "core/random.h"

#include <algorithm>
#include <numeric>

namespace scree {

GapSamples sample_gaps(const PlacedRegions& regions, const RegionDistance& distance,
                       std::size_t count, std::uint64_t seed) {
    const Box2 box = bounds(*regions.window.domain);
    const Vec2 size = box.size();
    const double side = std::sqrt(size.x * size.y / double(std::max<std::size_t>(count, 1)));
    const auto columns = static_cast<std::size_t>(std::max(1.0, std::round(size.x / side)));
    const auto rows = static_cast<std::size_t>(std::max(1.0, std::round(size.y / side)));
    const double outside = -std::numeric_limits<double>::infinity();
    std::vector<double> all(columns * rows);
    parallel_for(all.size(), 256, [&](std::size_t i) {
        Random random(seed, Purpose::analysis_sample, i);
        const double x = (double(i % columns) + random.uniform()) / double(columns);
        const double y = (double(i / columns) + random.uniform()) / double(rows);
        const Vec2 point = box.min + Vec2(x * size.x, y * size.y);
        all[i] = contains(*regions.window.domain, point) ? distance(point) : outside;
    });
    GapSamples samples;
    for (const double d : all) {
        samples.in_window += d != outside ? 1 : 0;
        if (d > 0 && std::isfinite(d))
            samples.distances.push_back(d);
    }
    return samples;
}

std::vector<double> neighbour_distances(const PlacedRegions& regions,
                                        const RegionDistance& distance) {
    std::vector<double> distances(regions.outlines.size());
    parallel_for(distances.size(), 64, [&](std::size_t i) {
        distances[i] = distance.to_neighbour(static_cast<std::uint32_t>(i));
    });
    return distances;
}

Summary summary(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty())
        return {};
    std::sort(values.begin(), values.end());
    const auto quantile = [&](double share) {
        const double at = share * double(values.size() - 1);
        const auto low = static_cast<std::size_t>(at);
        const std::size_t high = std::min(low + 1, values.size() - 1);
        return values[low] + (at - double(low)) * (values[high] - values[low]);
    };
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return {values.size(), sum / double(values.size()), quantile(0.5), quantile(0.95),
            values.back()};
}

Histogram histogram(std::span<const double> values, double limit, std::size_t bins) {
    Histogram result{limit / double(bins), std::vector<double>(bins)};
    std::size_t finite = 0;
    for (const double value : values) {
        if (!std::isfinite(value) || value < 0)
            continue;
        ++finite;
        // A value equal to the limit belongs to the last bin.
        const double bin = std::floor(value / result.bin_width);
        if (bin < double(bins))
            result.density[static_cast<std::size_t>(bin)] += 1;
        else if (value <= limit)
            result.density.back() += 1;
    }
    for (double& density : result.density)
        density /= std::max(1.0, double(finite)) * result.bin_width;
    return result;
}

} // namespace scree
