// SPDX-License-Identifier: GPL-3.0-or-later
// procedural.weathered: shares, limits and borders against their closed forms.
#include "core/random.h"
#include "procedurals/lichen.h"
#include "procedurals/table.h"
#include "tests/support/plugin_params.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

const Color base_color(0.3F, 0.2F, 0.1F);

std::shared_ptr<const Procedural> weathered(std::map<std::string, Value> values,
                                            const Color& base = base_color) {
    const Registry<MakeProcedural> table = procedural_table();
    values["base"] = tests::make(table, "checker", {{"color_a", base}, {"color_b", base}});
    return tests::make(table, "weathered", values);
}

ShadingSample sample_of(const Procedural& procedural, const ShadingPoint& point) {
    ShadingSample sample;
    procedural.evaluate({&point, 1}, {&sample, 1});
    return sample;
}

TEST(Lichen, CoversItsShareHoweverWideTheFilter) {
    for (const double cover : {0.1, 0.4, 0.75}) {
        const Lichen lichen(cover, 0.05, 3);
        for (const float width : {0.0F, 0.004F, 0.02F, 0.2F}) {
            Random random(1, Purpose::test);
            double sum = 0;
            constexpr int points = 40000;
            for (int i = 0; i < points; ++i) {
                const Vec3 p(float(random.uniform(0, 2)), float(random.uniform(0, 2)),
                             float(random.uniform(0, 2)));
                const Lichen::Seen seen = lichen.at(p, width, 1);
                EXPECT_GE(seen.cover, 0);
                EXPECT_LE(seen.cover, 1);
                sum += double(seen.cover);
            }
            // Ragged borders take as much as they give but for their curvature.
            EXPECT_NEAR(sum / points, cover, 0.06 + 0.1 * cover) << cover << ' ' << width;
        }
    }
}

TEST(Lichen, LeavesUndersidesBare) {
    const Lichen lichen(Lichen::most_cover, 0.05, 3);
    Random random(2, Purpose::test);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p(float(random.uniform()), float(random.uniform()), float(random.uniform()));
        EXPECT_EQ(lichen.at(p, 0, 0).cover, 0);
    }
}

TEST(Weathered, DustLiesOnWhatIsLevelOnly) {
    const Color dust(0.9F, 0.8F, 0.7F);
    const auto procedural =
        weathered({{"dust", 1.0}, {"dust_color", dust}, {"dust_angle", radians(40.0)}});
    ShadingPoint point{.position = Vec3(0.0F)};
    for (const float x : {0.0F, 0.1F, 0.37F}) {
        point.position = Vec3(x, 0, 2 * x);
        point.up = 1;
        EXPECT_NEAR((sample_of(*procedural, point).color - dust).length(), 0, 1e-6F);
        point.up = 0;
        EXPECT_EQ(sample_of(*procedural, point).color, base_color);
        point.up = -1;
        EXPECT_EQ(sample_of(*procedural, point).color, base_color);
    }
}

TEST(Weathered, IsWetBelowItsLine) {
    const auto procedural = weathered({{"wet_below", 0.3}, {"wet_edge", 0.02}});
    ShadingPoint point{.position = Vec3(0.0F)};
    point.level = 0.4F;
    const ShadingSample dry = sample_of(*procedural, point);
    EXPECT_EQ(dry.color, base_color);
    EXPECT_FLOAT_EQ(dry.roughness, 0.7F);
    point.level = 0.2F;
    const ShadingSample wet = sample_of(*procedural, point);
    EXPECT_LT(wet.roughness, 0.2F);
    for (int i = 0; i < 3; ++i) {
        EXPECT_LT(wet.color[i], 0.75F * base_color[i]);
        EXPECT_GT(wet.color[i], 0.4F * base_color[i]);
    }
    // Darker colours darken more, so that wet ones are more saturated.
    EXPECT_GT(wet.color[0] / wet.color[2], base_color[0] / base_color[2]);
}

TEST(Weathered, WhiteStaysWhiteUnderWaterButForItsReflection) {
    // Light that cannot leave comes back to a surface that absorbs nothing.
    const auto procedural = weathered({{"wet_below", 1.0}}, Color(1.0F));
    ShadingPoint point{.position = Vec3(0.0F)};
    EXPECT_NEAR(sample_of(*procedural, point).color[0], 0.98F, 1e-5F);
}

} // namespace
} // namespace scree
