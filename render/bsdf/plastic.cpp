// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/warps.h"
#include "render/bsdf/coat.h"
#include "render/bsdf/ggx_roughness.h"
#include "render/bsdf/prepared_material.h"

#include <algorithm>

namespace scree {

namespace {

/// A GGX coat over a diffuse base that gets what the coat lets in and gives back what it lets out
/// (Kelemen & Szirmay-Kalos 2001, eq. 14): reciprocal, and a white base loses nothing.
class PlasticLobe final : public Lobe {
  public:
    PlasticLobe() : Lobe({.diffuse = true, .mirrors = true}) {}

    BsdfValue evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi,
                       float diffuse_scale) const override {
        const Albedo& albedo = at.albedo;
        const float base =
            diffuse_scale * (1 - albedo.at(wo.z)) * (1 - albedo.at(wi.z)) / (1 - albedo.average());
        const float p = coat_probability(at, wo.z);
        const auto [reflected, pdf] = coat::evaluate(at, wo, wi, p);
        return {at.color * (base * wi.z / pi_f) + Color(reflected, reflected, reflected),
                pdf + (1 - p) * wi.z / pi_f};
    }

    BsdfSample sample(const Bsdf& at, const Vec3& wo, float choice, const Vec2f& u) const override {
        const bool coat = choice < coat_probability(at, wo.z);
        const Vec3 wi = coat ? ggx::reflect(wo, ggx::sample_visible_normal(wo, at.alpha, u))
                             : warp::cosine_hemisphere(u);
        if (wi.z <= 0)
            return {};
        const BsdfValue value = PlasticLobe::evaluate(at, wo, wi, 1);
        if (!(value.pdf > 0))
            return {};
        return {wi, value.value / value.pdf, value.pdf};
    }

  private:
    static float coat_probability(const Bsdf& at, float cosine) {
        const float coat = at.albedo.at(cosine);
        const float base = (1 - coat) * std::max({at.color.x, at.color.y, at.color.z});
        return coat / (coat + base);
    }
};

class PreparedPlastic final : public PreparedMaterial {
  public:
    PreparedPlastic(const Plastic& plastic, AlbedoTables& tables)
        : PreparedMaterial(plastic.paint),
          coat_(plastic.roughness, plastic.ior, plastic.paint, tables), ior_(plastic.ior) {}

    Bsdf bsdf(const Painted& painted, bool /*outside*/) const override {
        return coat_.bsdf(lobe_, painted, ior_);
    }

  private:
    PlasticLobe lobe_;
    GgxRoughness coat_;
    float ior_;
};

} // namespace

std::unique_ptr<const PreparedMaterial> Plastic::prepare(AlbedoTables& tables) const {
    return std::make_unique<const PreparedPlastic>(*this, tables);
}

} // namespace scree
