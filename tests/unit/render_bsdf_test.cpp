// SPDX-License-Identifier: GPL-3.0-or-later
// Every lobe's samples against its own density, and how much light it keeps.
#include "render/bsdf/ggx.h"
#include "render/sampler.h"
#include "tests/support/sampled_directions.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using test::check_directions;
using test::next_pair;

const Vec3 views[] = {Vec3(0.0F, 0.0F, 1.0F), Vec3(0.6F, 0.0F, 0.8F),
                      Vec3(-0.5F, 0.8F, 0.331662479F)};

void check_bsdf(const Bsdf& bsdf, int fine = 24) {
    for (const Vec3& wo : views)
        EXPECT_EQ(check_directions(
                      [&](Random& random) {
                          const float choice = random.uniform_float();
                          const BsdfSample s = bsdf.sample(wo, choice, next_pair(random));
                          return s.pdf > 0 && !s.delta ? s.direction : Vec3(0.0F, 0.0F, 0.0F);
                      },
                      [&](const Vec3& wi) { return bsdf.evaluate(wo, wi).pdf; }, fine),
                  "")
            << "wo.z = " << wo.z;
}

// Sampling weights, too, must be the value over the density.
void check_weights(const Bsdf& bsdf) {
    Random random(5, Purpose::test);
    for (const Vec3& wo : views)
        for (int i = 0; i < 2000; ++i) {
            const float choice = random.uniform_float();
            const BsdfSample s = bsdf.sample(wo, choice, next_pair(random));
            if (!(s.pdf > 0) || s.delta)
                continue;
            const BsdfValue v = bsdf.evaluate(wo, s.direction);
            ASSERT_NEAR(s.pdf / v.pdf, 1, 1e-2);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(s.weight[c], v.value[c] / v.pdf, 1e-3F + 1e-2F * s.weight[c]);
        }
}

double albedo(const Bsdf& bsdf, const Vec3& wo) {
    double sum = 0;
    for (std::uint32_t i = 0; i < 1U << 16; ++i) {
        const Sampler sampler(3, 0, 0, i);
        const BsdfSample s = bsdf.sample(wo, sampler.pair(0).x, sampler.pair(1));
        if (s.pdf > 0)
            sum += double(s.weight.y);
    }
    return sum / (1U << 16);
}

const Color white(1.0F, 1.0F, 1.0F);
const Paint white_paint{{white, nullptr}, {}};

// A material with a place that is painted white.
class White {
  public:
    template <class M>
    explicit White(const M& material) : prepared_(material.prepare(tables_)) {}

    Bsdf bsdf(bool outside = true) const { return prepared_->bsdf({white}, outside); }
    Bsdf bsdf_of_roughness(float roughness) const {
        return prepared_->bsdf({white, roughness}, true);
    }
    Bsdf emerging() const { return prepared_->subsurface()->emerging({white}); }

  private:
    AlbedoTables tables_;
    std::unique_ptr<const PreparedMaterial> prepared_;
};

Bsdf checked(const Bsdf& bsdf, int fine = 24) {
    check_bsdf(bsdf, fine);
    check_weights(bsdf);
    return bsdf;
}

// Rounded so that its square is the GGX alpha.
float roughness_of(float alpha) { return std::sqrt(alpha); }

// Answers nothing; a material that is painted with it takes its roughness from the place.
class NoTexture final : public Procedural {
  public:
    void evaluate(std::span<const ShadingPoint> /*points*/,
                  std::span<ShadingSample> /*samples*/) const override {}
};
const Paint textured{{Color(0.0F), std::make_shared<NoTexture>()}, {}};

TEST(Sampling, Matte) { checked(White(Matte{white_paint}).bsdf()); }

TEST(Sampling, Metal) {
    for (const float a : {0.2F, 0.8F}) {
        const White metal(Metal{white_paint, roughness_of(a)});
        checked(metal.bsdf());
    }
}

TEST(Sampling, Plastic) {
    for (const float a : {0.2F, 0.6F}) {
        const White plastic(Plastic{white_paint, roughness_of(a), 1.5F});
        checked(plastic.bsdf());
    }
}

TEST(Sampling, TranslucentOnTheWayInAndOut) {
    for (const float a : {0.2F, 0.6F}) {
        const White translucent(Translucent{white_paint, white, roughness_of(a), 1.5F});
        const Bsdf in = checked(translucent.bsdf());
        const Bsdf out = checked(translucent.emerging());
        for (const Vec3& wo : views) {
            EXPECT_NEAR(albedo(in, wo), 1, 0.01);
            EXPECT_NEAR(albedo(out, wo), 1, 0.001);
        }
    }
}

// Roughnesses between those of the tables; the smoothest makes a lobe just as wide as the cells can
// resolve.
TEST(Sampling, VariedRoughness) {
    const White metal(Metal{textured, 0.2F});
    const White plastic(Plastic{textured, 0.2F, 1.5F});
    for (const float roughness : {0.42F, 0.64F, 0.9F})
        for (const White* material : {&metal, &plastic}) {
            const Bsdf bsdf = checked(material->bsdf_of_roughness(roughness));
            EXPECT_EQ(bsdf.alpha, ggx::alpha(roughness));
        }
}

TEST(Sampling, VariedRoughnessKeepsTheAlbedo) {
    const White metal(Metal{textured, 0.2F});
    const White plastic(Plastic{textured, 0.2F, 1.5F});
    for (const float roughness : {0.0F, 0.02F, 0.11F, 0.172F, 0.3F, 0.484F, 0.703F, 0.95F, 1.0F})
        for (const float cosine : {0.05F, 0.3F, 0.7F, 1.0F}) {
            const Vec3 wo(std::sqrt(1 - cosine * cosine), 0.0F, cosine);
            EXPECT_NEAR(albedo(metal.bsdf_of_roughness(roughness), wo), 1, 0.005)
                << roughness << " " << cosine;
            EXPECT_NEAR(albedo(plastic.bsdf_of_roughness(roughness), wo), 1, 0.01)
                << roughness << " " << cosine;
        }
}

TEST(Sampling, RoughGlassFromBothSides) {
    const White glass(Glass{1.5F, Color(0.0F), roughness_of(0.6F)});
    for (const bool outside : {true, false})
        checked(glass.bsdf(outside), 64);
}

TEST(Sampling, VisibleNormals) {
    for (const Vec3& wo : views)
        EXPECT_EQ(
            check_directions(
                [&](Random& random) {
                    return ggx::sample_visible_normal(wo, 0.4F, next_pair(random));
                },
                [&](const Vec3& m) { return m.z > 0 ? ggx::visible_density(wo, m, 0.4F) : 0.0F; }),
            "");
}

TEST(Sampling, AlbedoIsOneForWhiteAndNeverMore) {
    for (const float a : {1.1e-3F, 0.04F, 0.25F, 1.0F}) {
        const White metal(Metal{white_paint, roughness_of(a)});
        const White plastic(Plastic{white_paint, roughness_of(a), 1.5F});
        const White glass(Glass{1.5F, Color(0.0F), roughness_of(a)});
        for (const float cosine : {0.05F, 0.3F, 0.7F, 1.0F}) {
            const Vec3 wo(std::sqrt(1 - cosine * cosine), 0.0F, cosine);
            EXPECT_NEAR(albedo(metal.bsdf(), wo), 1, 0.005) << a;
            EXPECT_NEAR(albedo(plastic.bsdf(), wo), 1, 0.01) << a;
            const double rough = albedo(glass.bsdf(), wo);
            EXPECT_FALSE(glass.bsdf().delta());
            EXPECT_LE(rough, 1.001);
            EXPECT_GE(rough, a < 0.3F ? 0.9 : 0.5);
        }
    }
}

TEST(Sampling, PlasticIsReciprocal) {
    const White plastic(Plastic{white_paint, roughness_of(0.3F), 1.5F});
    const Bsdf bsdf = plastic.bsdf();
    const float there = bsdf.evaluate(views[1], views[2]).value.x / views[2].z;
    const float back = bsdf.evaluate(views[2], views[1]).value.x / views[1].z;
    EXPECT_NEAR(there, back, 1e-5F);
}

} // namespace
} // namespace scree
