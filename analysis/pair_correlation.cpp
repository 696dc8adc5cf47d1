// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/pair_correlation.h"

#include "analysis/box_grid.h"
#include "analysis/covered_area.h"
#include "core/parallel.h"

#include <algorithm>

namespace scree {

namespace {

// The number of ordered pairs in each bin.
std::vector<double> count_pairs(std::span<const Vec2> points, const Window& window, double reach,
                                std::size_t bins) {
    Box2 frame = bounds(*window.domain);
    std::vector<Box2> boxes;
    for (const Vec2& point : points) {
        boxes.emplace_back(point, point);
        if (!window.torus)
            frame.extendBy(point);
    }
    const BoxGrid grid(boxes, frame, window.torus);
    // Counts are integers in doubles, so the sum is exact in any order.
    constexpr std::size_t points_per_part = 4096;
    const std::size_t parts = (points.size() + points_per_part - 1) / points_per_part;
    std::vector<std::vector<double>> counts(parts, std::vector<double>(bins));
    parallel_for(parts, 1, [&](std::size_t part) {
        const std::size_t end = std::min(points.size(), (part + 1) * points_per_part);
        for (std::size_t i = part * points_per_part; i < end; ++i) {
            const Vec2 reach2(reach, reach);
            grid.visit_box(
                {points[i] - reach2, points[i] + reach2}, [&](std::uint32_t j, const Vec2& shift) {
                    const double distance = (points[j] + shift - points[i]).length();
                    const auto bin = static_cast<std::size_t>(distance / reach * double(bins));
                    if (j != i && bin < bins)
                        counts[part][bin] += 1;
                });
        }
    });
    std::vector<double> sum(bins);
    for (const std::vector<double>& part : counts)
        for (std::size_t k = 0; k < bins; ++k)
            sum[k] += part[k];
    return sum;
}

} // namespace

double set_covariance(const Window& window, double r) {
    if (window.torus)
        return area(*window.domain);
    // Half a turn is enough, since translations by t and -t give the same area. The midpoint rule
    // with 16 directions has an error of 1e-3 for a rectangle at half its side, and less for
    // rounder windows.
    constexpr int directions = 16;
    double sum = 0;
    for (int d = 0; d < directions; ++d) {
        const Vec2 move = rotate({r, 0}, pi * (d + 0.5) / directions);
        Region moved{window.domain->rings, {}, {}};
        for (Ring& ring : moved.rings)
            for (Vec2& point : ring)
                point += move;
        sum += intersection_area(*window.domain, moved);
    }
    return sum / directions;
}

PairCorrelation pair_correlation(std::span<const Vec2> points, const Window& window, double reach,
                                 std::size_t bins) {
    PairCorrelation result{reach / double(bins), std::vector<double>(bins)};
    if (points.size() < 2)
        return result;
    const std::vector<double> counts = count_pairs(points, window, reach, bins);

    // The set covariance is smooth, so a few values with linear interpolation are enough.
    constexpr std::size_t knots = 33;
    std::vector<double> covariance(knots);
    parallel_for(knots, 1, [&](std::size_t i) {
        covariance[i] = set_covariance(window, reach * double(i) / double(knots - 1));
    });
    const double whole = area(*window.domain);
    const double n = double(points.size());
    const double density2 = n * (n - 1) / (whole * whole);
    for (std::size_t k = 0; k < bins; ++k) {
        const double low = double(k) * result.bin_width;
        const double high = low + result.bin_width;
        const double at = (double(k) + 0.5) / double(bins) * double(knots - 1);
        const auto knot = static_cast<std::size_t>(at);
        const double common =
            covariance[knot] + (at - double(knot)) * (covariance[knot + 1] - covariance[knot]);
        const double expected = density2 * common * pi * (high * high - low * low);
        result.value[k] = expected > 0 ? counts[k] / expected : 0;
    }
    return result;
}

} // namespace scree
