// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/region_shapes.h"
#include "shapes/table.h"
#include "tests/support/elements_params.h"
#include "tests/support/regions.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

Params bar_component() {
    // A bar whose middle is not its origin.
    Ring bar = rectangle_ring(0.1, 0.02);
    for (Vec2& v : bar)
        v += Vec2(0.3, 0.1);
    return tests::element_component(tests::region_of(bar));
}

Aggregate bars_on(const Mesh& mesh, std::size_t components) {
    Params params = tests::elements_params(std::vector<Params>(components, bar_component()));
    params.set("surface", std::make_shared<const Mesh>(mesh), {"scene.lua", 9});
    return elements_plugin().make(params)({});
}

Vec3 middle(const Instance& instance) {
    return transform_point(instance.world_from_object, {0.3F, 0, 0.1F});
}

Mesh ball() { return tests::make(component_table(), "sphere", {{"radius", 0.5}}); }

TEST(ElementsOnSurface, StandUprightOnIt) {
    const Aggregate aggregate = bars_on(ball(), 1);
    EXPECT_GT(aggregate.instances.size(), 100U);
    EXPECT_EQ(aggregate.domain, nullptr);
    for (const Instance& instance : aggregate.instances) {
        // The sphere stands on the ground; its facets are within 1% of its radius.
        const Vec3 outwards = middle(instance) - Vec3(0, 0.5F, 0);
        EXPECT_NEAR(outwards.length(), 0.5, 0.005);
        const Vec3 up = transform_direction(instance.world_from_object, {0, 1, 0});
        EXPECT_NEAR(up.dot(outwards.normalized()), 1, 1e-3);
        const Vec3 along = transform_direction(instance.world_from_object, {1, 0, 0});
        const Vec3 across = transform_direction(instance.world_from_object, {0, 0, 1});
        EXPECT_NEAR(across.cross(along).dot(up), 1, 1e-5); // turned, neither scaled nor mirrored
    }
}

TEST(ElementsOnSurface, KeepApartAtAnyTurn) {
    const Aggregate aggregate = bars_on(ball(), 1);
    const double diameter = std::hypot(0.1, 0.02);
    for (std::size_t i = 0; i < aggregate.instances.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT((middle(aggregate.instances[i]) - middle(aggregate.instances[j])).length(),
                      diameter * (1 - 1e-5));
}

TEST(ElementsOnSurface, ComponentsAreMixedEvenly) {
    const Aggregate aggregate = bars_on(ball(), 3);
    std::array<double, 3> counts{};
    for (const Instance& instance : aggregate.instances)
        ++counts[instance.prototype];
    const auto all = double(aggregate.instances.size());
    for (const double count : counts)
        EXPECT_NEAR(count / all, 1.0 / 3, 0.1);
}

} // namespace
} // namespace scree
