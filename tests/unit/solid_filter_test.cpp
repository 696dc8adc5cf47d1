// SPDX-License-Identifier: GPL-3.0-or-later
// What the filters answer against the mean of 4096 points within the filter.
#include "core/random.h"
#include "procedurals/table.h"
#include "tests/plugin_params.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace scree {

namespace {

using Values = std::map<std::string, Value>;

/// Root mean square errors over places and turns of filters `width` wide, drawn out by `slant`.
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

Errors errors(const std::string& name, Values values, double width, double slant, int places) {
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
            mean += double(sample.value) / (side * side);
        ShadingSample one, middle;
        filtered->evaluate({&point, 1}, {&one, 1});
        points->evaluate({&point, 1}, {&middle, 1});
        found.filtered += std::pow(double(one.value) - mean, 2) / places;
        found.point += std::pow(double(middle.value) - mean, 2) / places;
        found.bias += (double(one.value) - mean) / places;
    }
    found.filtered = std::sqrt(found.filtered);
    found.point = std::sqrt(found.point);
    return found;
}

} // namespace

TEST(SolidFilter, Print) {
    for (const char* preset : {"banded", "carrara", "nero_marquina"})
        for (const double slant : {1.0, 4.0, 16.0})
            for (const double cells : {0.1, 1.0, 3.0, 8.0, 16.0, 40.0}) {
                const Values values{{"preset", std::string(preset)}, {"detail", std::int64_t{1}}};
                const Errors e = errors("marble", values, cells * 0.1 / 64, slant, 60);
                std::printf("%s slant %g cells %g: point %.4f filtered %.4f bias %+.4f\n", preset,
                            slant, cells, e.point, e.filtered, e.bias);
            }
}

} // namespace scree
