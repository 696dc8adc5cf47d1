// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels on the host and on an OpenCL device.
#include "core/device.h"
#include "core/random.h"
#include "procedurals/table.h"
#include "tests/support/plugin_params.h"
#include "tests/support/shading_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace scree {

namespace {

using tests::difference;
using Values = std::map<std::string, Value>;

std::vector<ShadingPoint> scattered_points(std::size_t count, float extent) {
    Random random(21, Purpose::test);
    std::vector<ShadingPoint> points(count);
    for (ShadingPoint& point : points) {
        for (int k = 0; k < 3; ++k) {
            point.position[k] = extent * float(random.uniform(-1, 1));
            point.across[k] = float(random.uniform(-1, 1));
        }
        // Filters from much smaller than a cell to larger than the lattice; every fourth is a
        // point.
        const float width =
            random.below(4) == 0 ? 0 : float(1e-5 * std::pow(10, random.uniform(0, 4.5)));
        const Vec3 helper = point.across.cross(Vec3(0.3F, 0.5F, 0.7F)).normalized();
        point.across = point.across.normalized() * width;
        point.along = helper * width * float(random.uniform(1, 10));
        point.footprint = width;
        point.random = float(random.uniform());
    }
    return points;
}

void expect_device_agrees(const std::string& name, const Values& values) {
    const auto procedural = tests::make(procedural_table(), name, values);
    const std::vector<ShadingPoint> points = scattered_points(20000, 0.3F);
    std::vector<ShadingSample> host(points.size()), device(points.size()), one(points.size());
    procedural->bake(points, host, nullptr);
    procedural->evaluate(points, one);
    Device opened;
    procedural->bake(points, device, &opened);
    std::size_t far = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_LT(difference(host[i], one[i]), 1e-5) << name << " point " << i;
        if (!(difference(host[i], device[i]) < 1e-4))
            ++far;
    }
    // The last bit of a sine or exponential may decide on which side of a ring's end or a vessel's
    // edge an unfiltered point lies.
    EXPECT_LE(far, points.size() / 1000) << name;
}

} // namespace

TEST(SolidDevice, AgreesWithTheHost) {
    for (const char* preset : {"banded", "calacatta", "nero_marquina"})
        expect_device_agrees("marble", {{"preset", std::string(preset)},
                                        {"vein_height", 1e-4},
                                        {"filler_roughness", 0.1},
                                        {"vein_roughness", 0.4},
                                        {"iterations", std::int64_t{2}}});
    for (const char* preset : {"oak", "pine", "paper"})
        expect_device_agrees("wood", {{"preset", std::string(preset)},
                                      {"knots", 15.0},
                                      {"late_height", 1e-4},
                                      {"pore_depth", 1e-4},
                                      {"vary", true}});
}

TEST(SolidDevice, AgreesOnOtherLattices) {
    expect_device_agrees("marble", {{"repeats", false}, {"precision", std::string("32 bit")}});
    expect_device_agrees("wood", {{"levels", std::int64_t{3}}, {"detail", std::int64_t{7}}});
}

TEST(SolidDevice, NeverGivesNaN) {
    // At any place and with any filter, values are finite and colours are reflectances.
    for (const char* name : {"marble", "wood"})
        for (const bool repeats : {true, false}) {
            const auto procedural = tests::make(procedural_table(), name, {{"repeats", repeats}});
            for (const float extent : {0.0F, 1e-6F, 1.0F, 1e6F, 1e9F}) {
                std::vector<ShadingPoint> points = scattered_points(500, extent);
                for (std::size_t i = 0; i < points.size(); i += 5)
                    points[i].across = points[i].along = Vec3(extent);
                std::vector<ShadingSample> samples(points.size());
                procedural->evaluate(points, samples);
                for (const ShadingSample& s : samples) {
                    ASSERT_TRUE(is_finite(Vec3(s.color.x, s.color.y, s.color.z))) << extent;
                    ASSERT_TRUE(is_finite(s.slope) && std::isfinite(s.height)) << name << extent;
                    ASSERT_GE(s.value, -1e-4F);
                    ASSERT_LE(s.value, 1 + 1e-4F);
                }
            }
        }
}

} // namespace scree
