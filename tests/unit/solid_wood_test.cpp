// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts of wood along the trunk: what lies along the grain is lines, all else must look grown.
#include "core/parallel.h"
#include "procedurals/table.h"
#include "tests/support/plugin_params.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree {
namespace {

constexpr int side = 256;        // samples along an edge of a cut
constexpr double step = 0.45e-3; // [m]

/// The luminance on a plane along the trunk, `off` metres from the pith and turned about it by
/// `turn`: rows along the grain, columns from one side of the pith outwards.
std::vector<double> cut(const Procedural& wood, double off, double turn) {
    const double c = std::cos(turn), s = std::sin(turn);
    std::vector<ShadingPoint> points(std::size_t{side} * side);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double v = (j + 10) * step;
            ShadingPoint& point = points[std::size_t(j) * side + std::size_t(i)];
            point.position = Vec3(float(v * c - off * s), float(i * step), float(v * s + off * c));
            point.footprint = float(step);
            point.across = Vec3(0, float(step), 0);
            point.along = Vec3(float(step * c), 0, float(step * s));
        }
    std::vector<ShadingSample> samples(points.size());
    wood.bake(points, samples, nullptr);
    std::vector<double> out;
    for (const ShadingSample& sample : samples)
        out.push_back(double(luminance(sample.color)));
    return out;
}

/// The means along lines at `angle` from the grain, as wide as a sample and half a cut long, in
/// both halves of the cut: each half a row of numbers at equal distances across the lines.
std::vector<std::vector<double>> means_along(const std::vector<double>& cut, double angle) {
    constexpr int length = side / 2;
    const double x = std::cos(angle), y = std::sin(angle);
    std::vector<std::vector<double>> halves(2);
    for (int half = 0; half < 2; ++half)
        for (int k = -side / 4; k < side / 4; ++k) {
            // Lines through points of the half's middle, square to their direction.
            const double cx = side / 2.0 - k * y, cy = side * (half + 0.5) / 2 + k * x;
            double sum = 0;
            int count = 0;
            for (int t = -length / 2; t < length / 2; ++t) {
                const int i = int(std::floor(cx + t * x)), j = int(std::floor(cy + t * y));
                if (i < 0 || j < 0 || i >= side || j >= side)
                    continue;
                sum += cut[std::size_t(j) * side + std::size_t(i)];
                ++count;
            }
            if (count == length)
                halves[std::size_t(half)].push_back(sum / count);
        }
    return halves;
}

double variance(const std::vector<double>& values) {
    double sum = 0, squares = 0;
    for (const double v : values) {
        sum += v;
        squares += v * v;
    }
    const auto n = double(values.size());
    return values.empty() ? 0 : std::max(0.0, squares / n - sum * sum / (n * n));
}

TEST(SolidWood, CutsShowNoStraightBarsBesidesTheGrain) {
    constexpr std::array offsets{0.0, 0.0, 0.0, 0.5e-3, 1e-3, 2e-3, 4e-3, 9e-3, 20e-3, 45e-3};
    const auto table = procedural_table();
    std::vector<std::string> presets;
    for (const ParamSpec& spec : table.find("wood")->params)
        if (spec.name == "preset")
            presets = spec.choices;
    ASSERT_GE(presets.size(), 8U);
    std::size_t with_rays = 0;
    for (const std::string& preset : presets) {
        const std::map<std::string, Value> values{{"preset", preset}, {"size", 0.15}};
        std::map<std::string, Value> bare = values;
        bare["rays"] = bare["pores"] = 0.0;
        const auto wood = tests::make(table, "wood", values);
        const auto rings = tests::make(table, "wood", bare);
        for (std::size_t number = 0; number < offsets.size(); ++number) {
            // The first three pass through the pith, along the axes that sectors begin at.
            const double turn = (number < 3 ? 0.5 : 0.6) * pi * double(number);
            std::vector<double> seen = cut(*wood, offsets[number], turn);
            const std::vector<double> under = cut(*rings, offsets[number], turn);
            for (std::size_t i = 0; i < seen.size(); ++i)
                seen[i] -= under[i]; // rays and vessels alone
            const double whole = variance(seen);
            if (whole < 1e-9)
                continue;
            ++with_rays;
            // Lines of 58 mm: grown figures are shorter or crooked. Rays in planes gave 0.5 to 1.5.
            for (const double degrees : {25, 45, 65, 80, 90, 100, 115, 135, 155})
                for (const std::vector<double>& half : means_along(seen, radians(degrees)))
                    EXPECT_LT(variance(half) / whole, 0.35)
                        << preset << ", cut " << number << ", " << degrees << " degrees";
        }
    }
    EXPECT_GT(with_rays, 40U);
}

} // namespace
} // namespace scree
