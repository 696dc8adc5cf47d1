// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "generators/pile/shape_variation.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

#include <set>

namespace scree {
namespace {

using tests::component_mesh;

Random stream(std::uint64_t index) { return {3, Purpose::test, index}; }

Deformation some_deformation() {
    Deformation d;
    d.centre = {0.1F, -0.2F, 0.3F};
    d.along = Vec3(1, 2, -1).normalized();
    d.aside = d.along.cross(Vec3(0.3F, 1, 0)).normalized();
    d.length = 2;
    d.stretch = 1.2;
    d.twist = 0.9;
    d.bend = 0.7;
    d.scale = 1.3;
    return d;
}

TEST(PileVariation, BendsARodIntoAnArc) {
    Deformation d;
    d.length = 2;
    d.bend = pi / 2;
    const double radius = 2 / (pi / 2);
    for (const double x : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
        const Vec3 p = d.point({static_cast<float>(x), 0, 0});
        EXPECT_NEAR(double(p.x), radius * std::sin(x / radius), 1e-6);
        EXPECT_NEAR(double(p.y), radius * (1 - std::cos(x / radius)), 1e-6);
        EXPECT_NEAR(double(p.z), 0, 1e-6);
    }
}

TEST(PileVariation, TwistTurnsTheEndsAgainstEachOther) {
    Deformation d;
    d.length = 2;
    d.twist = pi / 2;
    const Vec3 low = d.point({-1, 1, 0});
    const Vec3 high = d.point({1, 1, 0});
    EXPECT_NEAR(double(low.dot(high)), -1,
                1e-6); // -1 along the axis; across it they are at right angles
    EXPECT_NEAR(double(high.y), std::cos(pi / 4), 1e-6);
    EXPECT_NEAR(double(high.z), std::sin(pi / 4), 1e-6);
}

TEST(PileVariation, NormalsArePerpendicularToDeformedSurfaces) {
    const Deformation d = some_deformation();
    for (std::uint64_t i = 0; i < 200; ++i) {
        Random random(2, Purpose::test, i);
        const auto vector = [&] {
            Vec3 v;
            for (int axis = 0; axis < 3; ++axis)
                v[axis] = static_cast<float>(random.uniform(-0.6, 0.6));
            return v;
        };
        const Vec3 p = d.centre + vector();
        const Vec3 n = vector().normalized();
        const Vec3 u = n.cross(vector()).normalized();
        const Vec3 v = n.cross(u);
        constexpr float h = 2e-3F;
        const Vec3 du = d.point(p + u * h) - d.point(p - u * h);
        const Vec3 dv = d.point(p + v * h) - d.point(p - v * h);
        // The deformation keeps the handedness of u, v and n.
        const Vec3 expected = du.cross(dv).normalized() * (u.cross(v).dot(n) > 0 ? 1.0F : -1.0F);
        EXPECT_LT(double((d.normal(p, n) - expected).length()), 2e-3);
    }
}

TEST(PileVariation, StretchAndTwistKeepTheVolume) {
    const Mesh mesh = component_mesh("banana", {});
    const ShapeVariation variation{.shapes = 4, .twist = 1, .stretch = 0.3};
    for (std::uint32_t i = 0; i < 4; ++i)
        EXPECT_NEAR(volume(varied_shape(mesh, variation, i, stream(i))) / volume(mesh), 1, 0.01);
}

TEST(PileVariation, ClosedStaysClosedAndPositive) {
    const ShapeVariation variation{
        .shapes = 6, .bend = 0.7, .twist = 1.5, .stretch = 0.2, .scale = {0.7, 1.3}};
    for (const std::string name : {"rice", "banana", "box", "gear", "torus"}) {
        const Mesh mesh = component_mesh(name, {});
        for (std::uint32_t i = 0; i < variation.shapes; ++i) {
            const Mesh shape = varied_shape(mesh, variation, i, stream(i));
            EXPECT_TRUE(inspect(shape).closed()) << name;
            EXPECT_GT(volume(shape), 0.3 * volume(mesh)) << name;
            EXPECT_LT(volume(shape), 2.4 * volume(mesh)) << name;
            if (name == "box")
                continue; // its triangles are too large to follow the deformation
            for (const Mesh::Triangle& t : shape.triangles) {
                const Vec3& a = shape.positions[t[0]];
                const Vec3 n = (shape.positions[t[1]] - a).cross(shape.positions[t[2]] - a);
                const Vec3& before = mesh.positions[t[0]];
                const Vec3 was =
                    (mesh.positions[t[1]] - before).cross(mesh.positions[t[2]] - before);
                if (was.normalized().dot(mesh.normals[t[0]]) > 0.9F) {
                    EXPECT_GT(n.dot(shape.normals[t[0]]), 0) << name;
                }
            }
        }
    }
}

TEST(PileVariation, SizesAreSpreadEvenly) {
    const Mesh mesh = component_mesh("sphere", {});
    const ShapeVariation variation{.shapes = 5, .scale = {0.5, 1.5}};
    const double before = std::cbrt(volume(mesh));
    for (std::uint32_t i = 0; i < 5; ++i) {
        const double scale =
            std::cbrt(volume(varied_shape(mesh, variation, i, stream(i)))) / before;
        EXPECT_GE(scale, 0.5 + 0.2 * i - 1e-4);
        EXPECT_LE(scale, 0.7 + 0.2 * i + 1e-4);
    }
}

TEST(PileVariation, WhatWouldFoldIsAnError) {
    const ShapeVariation variation{.shapes = 2, .bend = 2.5};
    EXPECT_THROW(varied_shape(component_mesh("box", {}), variation, 0, stream(0)), Error);
    EXPECT_NO_THROW(varied_shape(component_mesh("rice", {}), variation, 0, stream(0)));
}

Params varied_rice(int shapes) {
    Params rice = tests::pile_component(component_mesh("rice", {}));
    Params variation("generator.pile.components[1].variation", {"scene.lua", 21});
    variation.set("shapes", std::int64_t{shapes});
    variation.set("bend", 0.5);
    variation.set("twist", 0.5);
    variation.set("stretch", 0.1);
    variation.set("scale", Range{0.9, 1.1});
    rice.set("variation", std::make_shared<const std::vector<Params>>(1, variation));
    return rice;
}

Aggregate varied_pile(int shapes) {
    Params params =
        tests::pile_params(component_mesh("sphere", {{"radius", 0.012}}), {varied_rice(shapes)});
    params.set("rotation", Vec3(2 * pi_f));
    return pile_plugin().make(params)({});
}

TEST(PileVariation, APileOfAllShapesThatHardlyOverlap) {
    const Aggregate pile = varied_pile(5);
    ASSERT_EQ(pile.prototypes.size(), 5U);
    ASSERT_GT(pile.instances.size(), 50U);
    std::set<std::uint32_t> used;
    for (const Instance& instance : pile.instances)
        used.insert(instance.prototype);
    EXPECT_EQ(used.size(), 5U);
    EXPECT_LE(tests::fact(pile, "depth_max"), 0.02);
    EXPECT_GT(tests::fact(pile, "count"), 50);
}

// Neither components of one pile nor piles of different seeds have shapes in common.
TEST(PileVariation, ShapesDependOnComponentAndSeed) {
    constexpr int shapes = 8;
    const auto prototypes = [](std::int64_t seed) {
        Params params = tests::pile_params(component_mesh("sphere", {{"radius", 0.005}}),
                                           {varied_rice(shapes), varied_rice(shapes)});
        params.set("seed", seed);
        params.set("measure", std::int64_t{0});
        return pile_plugin().make(params)({}).prototypes;
    };
    std::set<float> seen; // where the first vertex lies
    for (const std::int64_t seed : {0, 1, shapes})
        for (const Prototype& prototype : prototypes(seed))
            EXPECT_TRUE(seen.insert(prototype.mesh()->positions.front().x).second)
                << seed << " " << prototype.name;
    EXPECT_EQ(seen.size(), 3U * 2 * shapes);
}

TEST(PileVariation, SameShapesOnAnyNumberOfThreads) {
    std::vector<Aggregate> piles;
    for (const int threads : {1, 3}) {
        const ThreadLimit limit(threads);
        piles.push_back(varied_pile(3));
    }
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(piles[0].prototypes[k].mesh()->positions,
                  piles[1].prototypes[k].mesh()->positions);
    ASSERT_EQ(piles[0].instances.size(), piles[1].instances.size());
    for (std::size_t i = 0; i < piles[0].instances.size(); ++i) {
        EXPECT_EQ(piles[0].instances[i].prototype, piles[1].instances[i].prototype);
        EXPECT_EQ(piles[0].instances[i].world_from_object, piles[1].instances[i].world_from_object);
    }
}

} // namespace
} // namespace scree
