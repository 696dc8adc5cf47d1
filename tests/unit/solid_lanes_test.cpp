// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of several points, one in each lane of a vector, against the same points one by one.
#include "core/random.h"
#include "procedurals/solid/lattice/vector_path.h"
#include "procedurals/table.h"
#include "tests/support/plugin_params.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

namespace scree {

namespace {

using Values = std::map<std::string, Value>;

/// Filters of all widths, some of them elongated, and some points.
std::vector<ShadingPoint> filters(std::size_t count, double extent) {
    Random random(41, Purpose::test);
    const auto direction = [&] {
        return Vec3(float(random.uniform(-1, 1)), float(random.uniform(-1, 1)),
                    float(random.uniform(-1, 1)))
            .normalized();
    };
    std::vector<ShadingPoint> points(count);
    for (ShadingPoint& point : points) {
        point.position =
            Vec3(float(random.uniform(-extent, extent)), float(random.uniform(-extent, extent)),
                 float(random.uniform(-extent, extent)));
        point.random = random.uniform_float();
        if (random.below(50) == 0)
            continue;
        const auto width = float(extent * std::pow(10, random.uniform(-5, 1)));
        const Vec3 side = direction();
        point.footprint = width;
        point.across = side * width;
        point.along = side.cross(direction()).normalized() * (width * float(random.uniform(1, 20)));
    }
    return points;
}

std::array<std::uint32_t, 9> bits(const ShadingSample& s) {
    const auto of = [](float v) { return std::bit_cast<std::uint32_t>(v + 0.0F); }; // -0 to 0
    return {of(s.color.x), of(s.color.y), of(s.color.z),   of(s.slope.x), of(s.slope.y),
            of(s.slope.z), of(s.height),  of(s.roughness), of(s.value)};
}

void expect_same_in_lanes(const std::string& name, const Values& values) {
    const auto procedural = tests::make(procedural_table(), name, values);
    const std::vector<ShadingPoint> points = filters(3000, 0.3);
    std::vector<ShadingSample> one_by_one(points.size());
    {
        const UseVectorPath scalar("scalar");
        for (std::size_t i = 0; i < points.size(); ++i)
            procedural->evaluate({&points[i], 1}, {&one_by_one[i], 1});
    }
    for (const std::string& path : vector_paths()) {
        const UseVectorPath use(path);
        std::vector<ShadingSample> together(points.size());
        // Groups of 1 to 21 points: some or all lanes of a vector, and several vectors.
        for (std::size_t first = 0, size = 1; first < points.size(); first += size) {
            size = std::min(first % 21 + 1, points.size() - first);
            procedural->evaluate({&points[first], size}, {&together[first], size});
        }
        for (std::size_t i = 0; i < points.size(); ++i)
            ASSERT_EQ(bits(together[i]), bits(one_by_one[i])) << name << " " << path << " " << i;
    }
}

TEST(SolidLanes, MarbleIsTheSameBitForBit) {
    const auto table = procedural_table();
    for (const ParamSpec& spec : table.find("marble")->params)
        if (spec.name == "preset")
            for (const std::string& preset : spec.choices)
                expect_same_in_lanes("marble", {{"preset", Value(preset)}, {"size", Value(0.3)}});
}

TEST(SolidLanes, MarbleIsTheSameWithAllParameters) {
    const auto with = [](Values values) {
        values["preset"] = Value(std::string("verde_alpi"));
        expect_same_in_lanes("marble", values);
    };
    with({{"iterations", Value(std::int64_t{2})}});
    with({{"vein_height", Value(1e-3)},
          {"filler_roughness", Value(0.2)},
          {"vein_roughness", Value(0.6)}});
    with({{"vary", Value(true)}});
    with({{"filtered", Value(false)}});
    with({{"levels", Value(std::int64_t{8})}});
    with({{"detail", Value(std::int64_t{0})}});
    Params vein("vein", {"scene.lua", 8}); // a single vein, not periodic
    vein.set("at", 0.05);
    vein.set("width", 0.01);
    vein.set("diffusion", 0.02);
    with({{"veins", std::make_shared<const std::vector<Params>>(1, vein)}});
    // Cases that are evaluated one by one.
    with({{"levels", Value(std::int64_t{5})}});
    with({{"repeats", Value(false)}});
    with({{"precision", Value(std::string("32 bit"))}});
}

} // namespace

} // namespace scree
