// SPDX-License-Identifier: GPL-3.0-or-later
// How fibres scatter light: energy, the paths of a smooth cylinder, sampling, and a ball of hair.
#include "model/fibre_color.h"
#include "render/bsdf/fibre_scattering.h"
#include "render/bsdf/prepared_material.h"
#include "tests/support/sampled_directions.h"
#include "tests/support/strands.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using fibre::path_count;

// From a slope [deg] at the offset h across the fibre.
template <class Real>
fibre::View<Real> view_of(const fibre::Scattering<Real>& scattering, double slope, double h) {
    const double cosine = std::cos(radians(slope));
    return scattering.view(Real(std::sin(radians(slope))), Real(cosine * h),
                           Real(cosine * std::sqrt(1 - h * h)));
}

// The integral of a path's density along the fibre, over the slope.
template <class Real>
double integral_along(const fibre::Scattering<Real>& scattering, int p,
                      const fibre::Slope<Real>& from) {
    constexpr int steps = 8000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double slope = pi * ((i + 0.5) / steps - 0.5);
        const double cosine = std::cos(slope);
        sum += double(scattering.along(p, from, {Real(std::sin(slope)), Real(cosine)})) * cosine;
    }
    return sum * pi / steps;
}

template <class Real>
double integral_around(const fibre::Scattering<Real>& scattering, int p,
                       const fibre::View<Real>& view) {
    constexpr int steps = 8000;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        sum += double(scattering.around(p, view, Real(2 * pi * ((i + 0.5) / steps - 0.5))));
    return sum * 2 * pi / steps;
}

// How far the light that a clear fibre scatters is from all the light, at the most.
template <class Real>
double largest_loss() {
    double worst = 0;
    for (const double beta_m : {0.05, 0.1, 0.2, 0.3, 0.5, 1.0})
        for (const double beta_n : {0.05, 0.3, 1.0})
            for (const double tilt : {-10.0, 0.0, 2.0, 10.0}) {
                const fibre::Scattering<Real> scattering(Real(beta_m), Real(beta_n), Real(1.55),
                                                         Real(radians(tilt)));
                for (const double slope : {-87.0, -40.0, 0.0, 30.0, 60.0, 80.0, 87.0}) {
                    std::array<double, path_count> along{};
                    for (int p = 0; p < path_count; ++p)
                        along[p] =
                            integral_along(scattering, p, view_of(scattering, slope, 0).theta);
                    for (const double h : {-0.999, -0.95, -0.5, 0.0, 0.3, 0.9}) {
                        const fibre::View<Real> view = view_of(scattering, slope, h);
                        const auto shares = scattering.shares(view, 1);
                        double sum = 0;
                        for (int p = 0; p < path_count; ++p)
                            sum += double(shares[p]) * along[p];
                        worst = std::max(worst, std::abs(sum - 1));
                    }
                }
            }
    return worst;
}

TEST(Fibre, ClearOnesLoseNoLight) {
    const double wide = largest_loss<double>();
    const double narrow = largest_loss<float>();
    EXPECT_LT(wide, 5e-4);
    EXPECT_LT(narrow, 2e-3);
    RecordProperty("furnace_double", std::to_string(wide));
    RecordProperty("furnace_float", std::to_string(narrow));
}

TEST(Fibre, TheDensityAroundIntegratesToOne) {
    for (const double beta_n : {0.05, 0.3, 1.0}) {
        const fibre::Scattering<double> wide(0.3, beta_n, 1.55, 0);
        const fibre::Scattering<float> narrow(0.3F, float(beta_n), 1.55F, 0);
        for (const double h : {-0.9, 0.0, 0.4})
            for (int p = 0; p < path_count; ++p) {
                EXPECT_NEAR(integral_around(wide, p, view_of(wide, 20, h)), 1, 1e-6);
                EXPECT_NEAR(integral_around(narrow, p, view_of(narrow, 20, h)), 1, 1e-4);
            }
    }
}

// The Bessel function by its power series (Abramowitz & Stegun 1964, 9.6.10).
TEST(Fibre, BesselFunction) {
    for (const double x : {0.0, 0.01, 0.7, 2.0, 3.7, 3.8, 9.0, 20.0, 50.0, 300.0}) {
        double term = std::exp(-x);
        double sum = 0;
        for (int k = 1; k < 2000; ++k) {
            sum += term;
            term *= x * x / 4 / (double(k) * k);
        }
        EXPECT_NEAR(fibre::scaled_bessel_i0(x) / sum, 1, 3e-7) << x;
        EXPECT_NEAR(double(fibre::scaled_bessel_i0(float(x))) / sum, 1, 2e-6) << x;
    }
}

struct Refraction {
    double reflected; // share of the light
    WideVec3 direction;
};

// At a surface with the unit normal n on the side of the ray; `eta` of the other side relative to
// this one (Snell 1621, Fresnel 1823).
Refraction refract(const WideVec3& d, const WideVec3& n, double eta) {
    const double cosine = -d.dot(n);
    const double sine2 = (1 - cosine * cosine) / (eta * eta);
    if (sine2 >= 1)
        return {1, {}};
    const double other = std::sqrt(1 - sine2);
    const double s = (cosine - eta * other) / (cosine + eta * other);
    const double p = (eta * cosine - other) / (eta * cosine + other);
    return {(s * s + p * p) / 2, d / eta + n * (cosine / eta - other)};
}

// Follows light into a smooth cylinder of radius 1 about the x axis, where it enters at z = h along
// a direction in the plane of x and y: the share that leaves by each path, and at which azimuth
// from the direction in which the cylinder is seen.
struct Traced {
    std::array<double, path_count> shares{};
    std::array<double, path_count - 1> azimuths{};
};
Traced trace_cylinder(double slope, double h, double eta, double absorption) {
    const auto normal_at = [](const WideVec3& p) { return WideVec3(0, p.y, p.z); };
    const auto azimuth = [](const WideVec3& d) { return std::atan2(d.z, d.y); };
    const WideVec3 d(-std::sin(slope), -std::cos(slope), 0);
    WideVec3 at(0, std::sqrt(1 - h * h), h);
    const Refraction in = refract(d, normal_at(at), eta);
    Traced out;
    out.shares[0] = in.reflected;
    out.azimuths[0] = azimuth(d - normal_at(at) * (2 * d.dot(normal_at(at))));
    double left = 1 - in.reflected;
    WideVec3 inside = in.direction;
    for (int p = 1; p < 300; ++p) {
        const double across2 = inside.y * inside.y + inside.z * inside.z;
        const double length = -2 * (at.y * inside.y + at.z * inside.z) / across2;
        at += inside * length;
        left *= std::exp(-absorption * length);
        const WideVec3 n = normal_at(at);
        const Refraction leaving = refract(inside, -n, 1 / eta);
        out.shares[std::min(p, path_count - 1)] += left * (1 - leaving.reflected);
        if (p < path_count - 1)
            out.azimuths[p] = azimuth(leaving.direction);
        left *= leaving.reflected;
        inside -= n * (2 * inside.dot(n));
    }
    return out;
}

TEST(Fibre, PathsAreThoseOfASmoothCylinder) {
    for (const double eta : {1.3, 1.55})
        for (const double absorption : {0.0, 0.5, 2.0})
            for (const double slope : {0.0, 30.0, -60.0, 80.0})
                for (const double h : {-0.9, -0.4, 0.2, 0.7}) {
                    const fibre::Scattering<double> scattering(0.3, 0.05, eta, 0);
                    const fibre::View<double> view = view_of(scattering, slope, h);
                    const auto shares =
                        scattering.shares(view, std::exp(-absorption * view.length));
                    const Traced traced = trace_cylinder(radians(slope), h, eta, absorption);
                    for (int p = 0; p < path_count; ++p)
                        EXPECT_NEAR(shares[p], traced.shares[p], 1e-6) << p << " " << h;
                    // The density around is greatest where the smooth cylinder sends the path; the
                    // traced azimuths are from the direction of view and turn the other way.
                    for (int p = 0; p < path_count - 1; ++p) {
                        const double exit = view.gamma - traced.azimuths[p];
                        EXPECT_GT(scattering.around(p, view, exit),
                                  0.999999 * scattering.around(p, view, exit + 1e-3));
                        EXPECT_GT(scattering.around(p, view, exit),
                                  0.999999 * scattering.around(p, view, exit - 1e-3));
                        EXPECT_GT(scattering.around(p, view, exit), 15) << p << " " << h;
                    }
                }
}

// By where the mirror image of a level view is in a surface whose normal leans by the tilt.
TEST(Fibre, ScalesMoveTheHighlightToTheRoot) {
    const double tilt = radians(3);
    const fibre::Scattering<double> scattering(0.1, 0.3, 1.55, tilt);
    const fibre::Slope<double> level{0, 1};
    const auto at = [&](int p, double slope) {
        return scattering.along(p, level, {std::sin(slope), std::cos(slope)});
    };
    EXPECT_GT(at(0, -2 * tilt), at(0, -tilt));
    EXPECT_GT(at(0, -2 * tilt), at(0, -3 * tilt));
    EXPECT_GT(at(2, 2 * tilt), 5 * at(2, -6 * tilt)) << "TRT goes the other way";
}

TEST(Fibre, ColorAndAbsorptionAreInverse) {
    for (const float beta_n : {0.05F, 0.3F, 0.7F, 1.0F})
        for (const float c : {0.02F, 0.3F, 0.9F, 1.0F}) {
            const Color color(c, 0.5F * c, 1);
            const Color back = fibre_color(fibre_absorption(color, beta_n), beta_n);
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(back[i], color[i], 1e-5F);
        }
}

class Fibres {
  public:
    explicit Fibres(Fibre fibre, const Color& color) : color_(color) {
        fibre.paint = {{color, nullptr}, {}};
        prepared_ = fibre.prepare(tables_);
    }
    Bsdf bsdf() const { return prepared_->bsdf({color_}, true); }

  private:
    AlbedoTables tables_;
    Color color_;
    std::unique_ptr<const PreparedMaterial> prepared_;
};

const Vec3 views[] = {Vec3(0.0F, 0.0F, 1.0F), Vec3(0.6F, 0.48F, 0.64F),
                      Vec3(-0.5F, -0.8F, 0.331662479F)};

TEST(Fibre, SamplingFollowsTheDensity) {
    const Color brown(0.6F, 0.3F, 0.1F);
    for (const auto& [fibre, color] :
         {std::pair(Fibre{.beta_m = 0.35F, .beta_n = 0.3F}, Color(1.0F)),
          {Fibre{.beta_m = 0.4F, .beta_n = 0.8F}, brown},
          {Fibre{.beta_m = 0.9F, .beta_n = 0.4F}, brown}}) {
        const Fibres fibres(fibre, color);
        const Bsdf bsdf = fibres.bsdf();
        for (const Vec3& wo : views)
            EXPECT_EQ(test::check_directions(
                          [&](Random& random) {
                              const float choice = random.uniform_float();
                              return bsdf.sample(wo, choice, test::next_pair(random)).direction;
                          },
                          [&](const Vec3& wi) { return bsdf.evaluate(wo, wi).pdf; }, 64),
                      "")
                << fibre.beta_m << " " << wo.z;
    }
}

TEST(Fibre, SamplesWeighTheValueOverTheDensity) {
    Random random(41, Purpose::test);
    for (const float beta : {0.05F, 0.3F, 1.0F}) {
        const Color color(0.9F, 0.4F, 0.1F);
        const Fibres fibres({.beta_m = beta, .beta_n = beta}, color);
        const Bsdf bsdf = fibres.bsdf();
        for (int i = 0; i < 20'000; ++i) {
            Vec3 wo = test::random_direction(random);
            wo.z = std::abs(wo.z);
            const float choice = random.uniform_float();
            const BsdfSample sample = bsdf.sample(wo, choice, test::next_pair(random));
            if (!(sample.pdf > 0))
                continue;
            ASSERT_NEAR(sample.direction.length(), 1, 1e-5F);
            ASSERT_EQ(sample.transmitted, sample.direction.z < 0);
            for (int c = 0; c < 3; ++c)
                ASSERT_TRUE(sample.weight[c] >= 0 && sample.weight[c] < 5) << sample.weight;
            const BsdfValue value = bsdf.evaluate(wo, sample.direction);
            ASSERT_NEAR(sample.pdf / value.pdf, 1, 2e-2F);
        }
    }
}

// Balls of clear hair, of all kinds of ends and bends, cannot be seen under a white sky.
TEST(Fibre, ABallOfClearHairIsInvisible) {
    Random random(42, Purpose::test);
    for (const CurveKind kind : {CurveKind::linear, CurveKind::bspline}) {
        const Strands hair = test::random_chains(random, 600, 12, 0.06F, 0.012F, 0.6F, kind);
        test::Stage stage;
        stage.film.width = stage.film.height = 24;
        stage.film.samples = 64;
        stage.film.depth = 1000;
        stage.camera.from = {0.0F, 1.0F, 3.0F};
        stage.camera.fov = 0.5F;
        stage.lights.push_back(test::even_sky(1));
        Aggregate aggregate;
        Fibre clear;
        clear.paint.texture.constant = Color(1.0F);
        aggregate.prototypes.push_back({.name = "hair",
                                        .shape = std::make_shared<const Strands>(hair),
                                        .materials = {std::make_shared<const Material>(clear)}});
        aggregate.instances.emplace_back();
        stage.aggregates.push_back(aggregate);
        for (const Mis mis : {Mis::both, Mis::bsdf_only}) {
            RenderOptions options;
            options.mis = mis;
            const RenderResult result = stage.render(options);
            const std::vector<ImagePart> parts = result.film.parts();
            double mean = 0;
            for (int y = 0; y < 24; ++y)
                for (int x = 0; x < 24; ++x)
                    mean += double(parts.front().image.at(x, y)[1]) / (24 * 24);
            EXPECT_NEAR(mean, 1, 0.01) << int(kind);
            EXPECT_EQ(result.stats.invalid_samples, 0U);
            EXPECT_GT(result.stats.rays, 3U * 24 * 24 * 64) << "most of them meet hair";
        }
    }
}

} // namespace
} // namespace scree
