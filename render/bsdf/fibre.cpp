// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/fibre_color.h"
#include "render/bsdf/fibre_scattering.h"
#include "render/bsdf/prepared_material.h"

namespace scree {

namespace {

using fibre::path_count;

/// The colour and the chance to be sampled of each path through a fibre.
struct Paths {
    std::array<Color, path_count> colors;
    std::array<float, path_count> chances{}; // sum to 1
};

/// In the frame of a place of a fibre x is its axis, z the normal.
class FibreLobe final : public Lobe {
  public:
    explicit FibreLobe(const Fibre& fibre)
        : Lobe({.two_sided = true, .oriented = true, .goes_through = true}),
          scattering_(fibre.beta_m, fibre.beta_n, fibre.eta, fibre.tilt), beta_n_(fibre.beta_n) {}

    BsdfValue evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi,
                       float /*diffuse_scale*/) const override {
        const fibre::View<float> view = scattering_.view(wo.x, wo.y, wo.z);
        return evaluate(view, paths(at, view), wi);
    }

    BsdfSample sample(const Bsdf& at, const Vec3& wo, float choice, const Vec2f& u) const override {
        const fibre::View<float> view = scattering_.view(wo.x, wo.y, wo.z);
        const Paths paths = this->paths(at, view);
        int p = 0;
        while (p < path_count - 1 && choice >= paths.chances[p])
            choice -= paths.chances[p++];
        if (!(paths.chances[p] > 0))
            return {};
        // What is left of the choice is uniform again.
        const float rest = std::clamp(choice / paths.chances[p], 0.0F, 1 - 0x1p-24F);
        const float sine = scattering_.sample_along(p, view.theta, u.x, u.y);
        const float cosine = std::sqrt(1 - sine * sine);
        const float azimuth = scattering_.sample_around(p, view, rest);
        const Vec3 wi(sine, cosine * std::sin(azimuth), cosine * std::cos(azimuth));
        const BsdfValue value = evaluate(view, paths, wi);
        if (!(value.pdf > 0))
            return {};
        return {wi, value.value / value.pdf, value.pdf, false, wi.z < 0};
    }

  private:
    Paths paths(const Bsdf& at, const fibre::View<float>& view) const {
        const Color absorption = fibre_absorption(at.color, beta_n_);
        Paths out;
        for (int channel = 0; channel < 3; ++channel) {
            const auto shares =
                scattering_.shares(view, std::exp(-absorption[channel] * view.length));
            for (int p = 0; p < path_count; ++p)
                out.colors[p][channel] = shares[p];
        }
        float sum = 0;
        for (const Color& color : out.colors)
            sum += luminance(color);
        for (int p = 0; p < path_count; ++p)
            out.chances[p] = luminance(out.colors[p]) / sum;
        return out;
    }

    BsdfValue evaluate(const fibre::View<float>& view, const Paths& paths, const Vec3& wi) const {
        const float cosine2 = wi.y * wi.y + wi.z * wi.z;
        const fibre::Slope<float> theta{wi.x, std::sqrt(cosine2)};
        const float azimuth = std::atan2(wi.y, wi.z);
        BsdfValue out;
        for (int p = 0; p < path_count; ++p) {
            const float density =
                scattering_.along(p, view.theta, theta) * scattering_.around(p, view, azimuth);
            out.value += paths.colors[p] * density;
            out.pdf += paths.chances[p] * density;
        }
        return out;
    }

    fibre::Scattering<float> scattering_;
    float beta_n_;
};

class PreparedFibre final : public PreparedMaterial {
  public:
    explicit PreparedFibre(const Fibre& fibre) : PreparedMaterial(fibre.paint), lobe_(fibre) {}

    Bsdf bsdf(const Painted& painted, bool /*outside*/) const override {
        return {&lobe_, painted.color};
    }

  private:
    FibreLobe lobe_;
};

} // namespace

std::unique_ptr<const PreparedMaterial> Fibre::prepare(AlbedoTables& /*tables*/) const {
    return std::make_unique<const PreparedFibre>(*this);
}

} // namespace scree
