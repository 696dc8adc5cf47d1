// SPDX-License-Identifier: GPL-3.0-or-later
// Filtered values against the mean of 4096 points within the filter.
#include "core/random.h"
#include "procedurals/table.h"
#include "tests/support/plugin_params.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace scree {

namespace {

using Values = std::map<std::string, Value>;

/// Root mean square errors over random places and orientations of filters of a `width`, elongated
/// by `slant`.
struct Errors {
    double point = 0;
    double filtered = 0;
    double bias = 0;
};

Vec3 direction(Random& random) {
    const double z = random.uniform(-1, 1), a = random.uniform(0, 2 * pi);
    const double r = std::sqrt(1 - z * z);
    return {float(r * std::cos(a)), float(r * std::sin(a)), float(z)};
}

using Pick = double (*)(const ShadingSample& sample);

Errors errors(const std::string& name, Values values, Pick pick, double width, double slant,
              int places) {
    values["filtered"] = Value(true);
    const auto filtered = tests::make(procedural_table(), name, values);
    values["filtered"] = Value(false);
    const auto points = tests::make(procedural_table(), name, values);
    Random random(11, Purpose::test);
    Errors found;
    constexpr int side = 64;
    std::vector<ShadingPoint> inside(side * side);
    std::vector<ShadingSample> seen(side * side);
    for (int i = 0; i < places; ++i) {
        ShadingPoint point;
        for (int k = 0; k < 3; ++k)
            point.position[k] = float(random.uniform(-0.2, 0.2));
        point.footprint = float(width);
        const Vec3 a = direction(random), helper = direction(random);
        point.across = a * point.footprint;
        point.along = a.cross(helper).normalized() * float(width * slant);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                ShadingPoint& p = inside[std::size_t(y * side + x)];
                p = point;
                p.position += point.across * ((float(x) + float(random.uniform())) / side - 0.5F) +
                              point.along * ((float(y) + float(random.uniform())) / side - 0.5F);
                p.across = p.along = Vec3(0.0F);
            }
        points->evaluate(inside, seen);
        double mean = 0;
        for (const ShadingSample& sample : seen)
            mean += pick(sample) / (side * side);
        ShadingSample one, middle;
        filtered->evaluate({&point, 1}, {&one, 1});
        points->evaluate({&point, 1}, {&middle, 1});
        found.filtered += std::pow(pick(one) - mean, 2) / places;
        found.point += std::pow(pick(middle) - mean, 2) / places;
        found.bias += (pick(one) - mean) / places;
    }
    found.filtered = std::sqrt(found.filtered);
    found.point = std::sqrt(found.point);
    return found;
}

double value_of(const ShadingSample& sample) { return double(sample.value); }
double green_of(const ShadingSample& sample) { return double(sample.color.y); }

/// Checks the errors of a texture at several widths, in cells of the paper's lattice, and slants.
void expect_good_filter(const std::string& name, const std::string& preset, double best_ratio,
                        Pick pick = value_of) {
    double point = 0, filtered = 0, bias = 0;
    int count = 0;
    for (const double slant : {1.0, 4.0, 16.0})
        for (const double cells : {0.05, 1.0, 3.0, 8.0, 16.0, 40.0}) {
            const Values values{{"preset", preset}, {"detail", std::int64_t{1}}};
            const Errors e = errors(name, values, pick, cells * 0.1 / 64, slant, 40);
            std::printf("%s %s, slant %g, %g cells: point %.4f filtered %.4f bias %+.4f\n",
                        name.c_str(), preset.c_str(), slant, cells, e.point, e.filtered, e.bias);
            EXPECT_LT(e.filtered, 0.65 * e.point + 0.008)
                << name << " " << preset << " slant " << slant << " cells " << cells;
            point += e.point * e.point;
            filtered += e.filtered * e.filtered;
            bias += e.bias;
            ++count;
        }
    EXPECT_LT(std::sqrt(filtered / point), best_ratio) << name << " " << preset;
    EXPECT_LT(std::abs(bias / count), 0.02) << name << " " << preset;
}

} // namespace

TEST(SolidFilter, OfMarbleComesNearTheMeanOf4096Points) {
    expect_good_filter("marble", "banded", 0.25);
    expect_good_filter("marble", "carrara", 0.25);
    expect_good_filter("marble", "nero_marquina", 0.15);
}

TEST(SolidFilter, OfWoodComesNearTheMeanOf4096Points) {
    expect_good_filter("wood", "paper", 0.25);
    expect_good_filter("wood", "pine", 0.25);
    expect_good_filter("wood", "walnut", 0.25);
}

TEST(SolidFilter, OfVesselsRaysAndFibresComesNearTheMeanOf4096Points) {
    expect_good_filter("wood", "oak", 0.35, green_of);
    expect_good_filter("wood", "beech", 0.35, green_of);
}

} // namespace scree
