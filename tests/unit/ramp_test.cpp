// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "procedurals/table.h"
#include "tests/support/plugin_params.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

Params stop(double at, const Color& color) {
    Params params;
    params.set("at", at);
    params.set("color", color);
    return params;
}

std::shared_ptr<const Procedural> ramp(std::vector<Params> stops) {
    return tests::make(procedural_table(), "ramp",
                       {{"from", Vec3(-1, 0, 0)},
                        {"to", Vec3(3, 0, 0)},
                        {"stops", std::make_shared<const std::vector<Params>>(std::move(stops))}});
}

Color color_at(const Procedural& ramp, float x, float width = 0, float random = 0) {
    ShadingPoint point;
    point.position = {x, 5, -7};
    point.along = {width, 0, 0};
    point.random = random;
    ShadingSample sample;
    ramp.evaluate({&point, 1}, {&sample, 1});
    return sample.color;
}

const Color red(1, 0, 0);
const Color green(0, 1, 0);
const Color blue(0, 0, 1);

void expect_near(const Color& a, const Color& b) {
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(double(a[k]), double(b[k]), 2e-3);
}

TEST(Ramp, JoinsItsStopsByStraightLines) {
    const auto colors = ramp({stop(0.25, red), stop(0.5, green), stop(1, blue)});
    expect_near(color_at(*colors, -5), red);
    expect_near(color_at(*colors, 0), red);
    expect_near(color_at(*colors, 0.5F), Color(0.5F, 0.5F, 0));
    expect_near(color_at(*colors, 1), green);
    expect_near(color_at(*colors, 2.5F), Color(0, 0.25F, 0.75F));
    expect_near(color_at(*colors, 9), blue);
}

TEST(Ramp, FilterIsTheMeanOverThePixel) {
    const auto colors = ramp({stop(0.25, red), stop(0.3, green), stop(0.3, blue), stop(0.9, red)});
    for (const float width : {0.1F, 1.0F, 3.0F, 9.0F})
        for (const float x : {-1.0F, 0.1F, 0.4F, 2.0F}) {
            Color mean(0.0F);
            constexpr int count = 2000;
            for (int i = 0; i < count; ++i)
                mean += color_at(*colors, x + width * ((float(i) + 0.5F) / count - 0.5F)) / count;
            expect_near(color_at(*colors, x, width), mean);
        }
}

TEST(Ramp, InstancesHaveIndividualMixtures) {
    Params both = stop(0, red);
    both.set("other", blue);
    const auto colors = ramp({both});
    expect_near(color_at(*colors, 0, 0, 0.25F), Color(0.75F, 0, 0.25F));
    EXPECT_FALSE(colors->solid());
    EXPECT_TRUE(ramp({stop(0, red)})->solid());
}

TEST(Ramp, StopsThatGoBackAreAnError) {
    EXPECT_THROW(ramp({stop(0.5, red), stop(0.4, green)}), Error);
}

} // namespace
} // namespace scree
