// SPDX-License-Identifier: GPL-3.0-or-later
// Granite, breccia, stone, leather and bark: properties that all presets must have.
#include "core/device.h"
#include "core/parallel.h"
#include "core/random.h"
#include "procedurals/table.h"
#include "tests/support/plugin_params.h"
#include "tests/support/shading_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <ostream>

namespace scree {

namespace {

using tests::difference;
using Values = std::map<std::string, Value>;

/// A texture with one of its presets, and the width of its most visible cells [m].
struct Material {
    std::string name, preset;
    double cell;
};

std::ostream& operator<<(std::ostream& out, const Material& material) {
    return out << material.name << " " << material.preset;
}

std::vector<Material> materials() {
    const std::pair<const char*, double> cells[] = {
        {"granite", 6e-3}, {"breccia", 25e-3}, {"stone", 6e-3}, {"leather", 2e-3}, {"bark", 20e-3}};
    const auto table = procedural_table();
    std::vector<Material> found;
    for (const auto& [name, cell] : cells)
        for (const ParamSpec& spec : table.find(name)->params)
            if (spec.name == "preset")
                for (const std::string& preset : spec.choices)
                    found.push_back({name, preset, cell});
    return found;
}

std::shared_ptr<const Procedural> made(const Material& material, Values values = {}) {
    values["preset"] = Value(material.preset);
    return tests::make(procedural_table(), material.name, values);
}

Vec3 direction(Random& random) {
    const double z = random.uniform(-1, 1), a = random.uniform(0, 2 * pi);
    const double r = std::sqrt(1 - z * z);
    return {float(r * std::cos(a)), float(r * std::sin(a)), float(z)};
}

Vec3 place(Random& random, double extent) {
    return {float(random.uniform(-extent, extent)), float(random.uniform(-extent, extent)),
            float(random.uniform(-extent, extent))};
}

ShadingPoint point_at(const Vec3& position) {
    ShadingPoint point;
    point.position = position;
    return point;
}

/// A randomly oriented filter of a `width`, elongated by `slant`.
ShadingPoint filter_at(const Vec3& position, double width, double slant, Random& random) {
    ShadingPoint point = point_at(position);
    const Vec3 a = direction(random);
    point.footprint = float(width);
    point.across = a * float(width);
    point.along = a.cross(direction(random)).normalized() * float(width * slant);
    return point;
}

double lightness(const ShadingSample& s) {
    return 0.2126 * double(s.color.x) + 0.7152 * double(s.color.y) + 0.0722 * double(s.color.z);
}

ShadingSample sample_of(const Procedural& procedural, const ShadingPoint& point) {
    ShadingSample sample;
    procedural.evaluate({&point, 1}, {&sample, 1});
    return sample;
}

class SolidMaterial : public testing::TestWithParam<Material> {};

std::vector<ShadingPoint> scattered_points(std::size_t count, double extent, Random& random) {
    std::vector<ShadingPoint> points(count);
    for (ShadingPoint& point : points) {
        const double width = random.below(4) == 0 ? 0 : 1e-5 * std::pow(10, random.uniform(0, 4.5));
        point = filter_at(place(random, extent), width, random.uniform(1, 10), random);
        point.random = random.uniform_float();
    }
    return points;
}

/// Sums of squares and of errors of unfiltered points and of the filter, against means of 4096
/// points.
struct FilterErrors {
    double point = 0, filtered = 0, bias = 0;
    int places = 0;
};

void add_filter_errors(const Material& material, double width, double slant, int places,
                       FilterErrors& errors) {
    const auto filtered = made(material), points = made(material, {{"filtered", Value(false)}});
    Random random(11, Purpose::test);
    constexpr int side = 32; // stratified, so as accurate as 4096 random points
    std::vector<ShadingPoint> inside(side * side);
    std::vector<ShadingSample> seen(side * side);
    for (int i = 0; i < places; ++i) {
        const ShadingPoint point = filter_at(place(random, 0.2), width, slant, random);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                inside[std::size_t(y * side + x)] =
                    point_at(point.position +
                             point.across * ((float(x) + random.uniform_float()) / side - 0.5F) +
                             point.along * ((float(y) + random.uniform_float()) / side - 0.5F));
        points->evaluate(inside, seen);
        double mean = 0;
        for (const ShadingSample& sample : seen)
            mean += lightness(sample) / (side * side);
        const double one = lightness(sample_of(*filtered, point));
        errors.filtered += std::pow(one - mean, 2);
        errors.point += std::pow(lightness(sample_of(*points, point)) - mean, 2);
        errors.bias += one - mean;
        ++errors.places;
    }
}

} // namespace

TEST(SolidMaterials, FiltersComeNearTheMeanOfManyPoints) {
    constexpr std::pair<double, double> filters[] = {{1, 0.1}, {1, 0.3}, {1, 1}, {1, 3}, {1, 10},
                                                     {1, 40},  {5, 0.3}, {5, 3}, {5, 40}};
    for (const auto& [slant, cells] : filters) {
        std::map<std::string, FilterErrors> errors; // the presets of each texture together
        for (const Material& material : materials())
            add_filter_errors(material, cells * material.cell, slant, 8, errors[material.name]);
        for (const auto& [name, sums] : errors) {
            const double point = std::sqrt(sums.point / sums.places),
                         filtered = std::sqrt(sums.filtered / sums.places),
                         bias = sums.bias / sums.places;
            const testing::Message where = testing::Message()
                                           << name << " slant " << slant << " cells " << cells;
            // Beds fade to their mean before a filter covers many of them.
            EXPECT_LT(filtered, (cells < 1 || name == "stone" ? 0.7 : 0.5) * point) << where;
            // Three standard errors: one of 370 values would exceed them by chance.
            EXPECT_LT(std::abs(bias), 0.1 * point + 3 * filtered / std::sqrt(sums.places)) << where;
        }
    }
}

TEST_P(SolidMaterial, LooksTheSameToAPointAndToANarrowFilter) {
    // Without turbulence an unfiltered point has width 0, by which nothing may divide.
    const auto procedural = made(GetParam(), {{"turbulence", Value(0.0)}});
    Random random(23, Purpose::test);
    constexpr int places = 2000;
    int differ = 0;
    for (int i = 0; i < places; ++i) {
        const ShadingPoint filter = filter_at(place(random, 0.2), 1e-6, 1, random);
        const double one = lightness(sample_of(*procedural, filter)),
                     other = lightness(sample_of(*procedural, point_at(filter.position)));
        differ += std::abs(one - other) > 0.02;
    }
    EXPECT_LE(differ, places / 200); // on borders
}

TEST_P(SolidMaterial, SlopeIsTheHeightsGradient) {
    const Material& material = GetParam();
    Values values;
    if (material.name == "granite" || material.name == "breccia" || material.name == "stone")
        values["relief"] = Value(1e-3);
    const auto procedural = made(material, values);
    Random random(5, Purpose::test);
    constexpr int places = 3000;
    double size = 0;
    int far = 0;
    for (int i = 0; i < places; ++i) {
        const Vec3 p = place(random, 0.05), step = direction(random) * 2e-6F;
        const ShadingSample before = sample_of(*procedural, point_at(p - step)),
                            after = sample_of(*procedural, point_at(p + step)),
                            middle = sample_of(*procedural, point_at(p));
        const Vec3 run = (p + step) - (p - step);
        const double slope = double(middle.slope.dot(run.normalized()));
        const double numeric =
            (double(after.height) - double(before.height)) / double(run.length());
        if (std::abs(numeric - slope) > 0.02 + 0.05 * std::abs(slope))
            ++far;
        size += slope * slope;
    }
    EXPECT_GT(size / places, 1e-4);
    // The trilinear field has kinks between its cells, and edges are steep.
    EXPECT_LE(far, places / 50);
}

namespace {

/// The change of `f` over the part of [a, b] that repeated bisection towards the larger change
/// finds.
template <class F>
double change_left(const F& f, double a, double b, int halvings) {
    for (int i = 0; i < halvings; ++i) {
        const double middle = (a + b) / 2;
        (std::abs(f(middle) - f(a)) > std::abs(f(b) - f(middle)) ? b : a) = middle;
    }
    return std::abs(f(b) - f(a));
}

} // namespace

TEST_P(SolidMaterial, HasNoSeams) {
    // Neither the height of points nor the filtered colour is discontinuous at borders of a grid or
    // at limits of the search for seeds. The change over a steep edge shrinks with the step, that
    // over a discontinuity does not.
    const Material& material = GetParam();
    // Without turbulence, since the warping field has kinks, where the width of filters changes
    // abruptly.
    const auto procedural = made(material, {{"turbulence", Value(0.0)}});
    Random random(17, Purpose::test);
    constexpr int steps = 1200, halvings = 7;
    for (int line = 0; line < 4; ++line) {
        const Vec3 start = place(random, 0.05);
        const double width = material.cell * (0.2 + 0.4 * line), step = width / 100;
        ShadingPoint filter = filter_at(start, width, 1, random);
        // In the plane of the filter, which has no extent perpendicular to it.
        const Vec3 along = (filter.across + filter.along * random.uniform_float()).normalized();
        const auto color = [&](double t) {
            filter.position = start + along * float(t);
            return lightness(sample_of(*procedural, filter));
        };
        const auto height = [&](double t) {
            return double(sample_of(*procedural, point_at(start + along * float(t))).height);
        };
        for (int i = 0; i < steps; ++i) {
            const double a = i * step, b = a + step;
            if (std::abs(color(b) - color(a)) > 0.1) {
                ASSERT_LT(change_left(color, a, b, halvings), 0.1) << line << " " << i;
            }
            if (std::abs(height(b) - height(a)) > 4e-5) {
                ASSERT_LT(change_left(height, a, b, halvings), 4e-5) << line << " " << i;
            }
        }
    }
}

TEST_P(SolidMaterial, DeviceAgrees) {
    // The last bit may decide between two cells for unfiltered points: at most one in 2000.
    const auto procedural = made(GetParam());
    Random random(21, Purpose::test);
    const std::vector<ShadingPoint> points = scattered_points(8192, 0.3, random);
    std::vector<ShadingSample> host(points.size()), device(points.size());
    procedural->bake(points, host, nullptr);
    static Device opened; // compiles each texture once for all its presets
    procedural->bake(points, device, &opened);
    std::size_t far = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        far += difference(host[i], device[i]) < 1e-4 ? 0 : 1;
    EXPECT_LE(far, points.size() / 2000);
}

TEST_P(SolidMaterial, IsTheSameOnAnyThreads) {
    const auto procedural = made(GetParam(), {{"vary", Value(true)}});
    Random random(31, Purpose::test);
    const std::vector<ShadingPoint> points = scattered_points(3000, 0.3, random);
    std::vector<ShadingSample> one(points.size()), many(points.size());
    {
        const ThreadLimit limit(1);
        procedural->bake(points, one, nullptr);
    }
    {
        const ThreadLimit limit(4);
        procedural->bake(points, many, nullptr);
    }
    EXPECT_EQ(std::memcmp(one.data(), many.data(), one.size() * sizeof(ShadingSample)), 0);
}

TEST_P(SolidMaterial, NeverGivesNaN) {
    Random random(8, Purpose::test);
    for (const bool repeats : {true, false})
        for (const double extent : {0.0, 1e-6, 1.0, 1e6, 1e20}) {
            const auto procedural = made(GetParam(), {{"repeats", Value(repeats)}});
            std::vector<ShadingPoint> points = scattered_points(200, extent, random);
            for (std::size_t i = 0; i < points.size(); i += 5)
                points[i].across = points[i].along = Vec3(float(extent));
            std::vector<ShadingSample> samples(points.size());
            procedural->evaluate(points, samples);
            for (const ShadingSample& s : samples) {
                for (int k = 0; k < 3; ++k) {
                    ASSERT_TRUE(s.color[k] >= 0 && s.color[k] < 2) << extent << " " << s.color;
                    ASSERT_TRUE(std::isfinite(s.slope[k])) << extent;
                }
                ASSERT_TRUE(std::isfinite(s.height)) << extent;
                ASSERT_TRUE(s.roughness >= 0 && s.roughness <= 1) << extent << s.roughness;
                ASSERT_TRUE(s.value >= -1e-4F && s.value <= 1 + 1e-4F) << extent << s.value;
            }
        }
}

INSTANTIATE_TEST_SUITE_P(All, SolidMaterial, testing::ValuesIn(materials()),
                         [](const auto& tested) {
                             return tested.param.name + "_" + tested.param.preset;
                         });

} // namespace scree
