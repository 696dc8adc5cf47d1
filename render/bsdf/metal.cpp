// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/fresnel.h"
#include "render/bsdf/ggx_roughness.h"
#include "render/bsdf/prepared_material.h"

namespace scree {

namespace {

/// Facets of a conductor.
class MetalLobe final : public Lobe {
  public:
    MetalLobe() : Lobe({.mirrors = true}) {}

    BsdfValue evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi,
                       float /*diffuse_scale*/) const override {
        const Vec3 m = ggx::half_vector(wo, wi);
        const float normal_density = ggx::density(m, at.alpha) / (4 * wo.z);
        return {fresnel_schlick(wo.dot(m), at.color) * gain(at, wo.z) *
                    (normal_density * ggx::shadowing(wo, wi, at.alpha)),
                normal_density * ggx::masking(wo, at.alpha)};
    }

    BsdfSample sample(const Bsdf& at, const Vec3& wo, float /*choice*/,
                      const Vec2f& u) const override {
        const Vec3 m = ggx::sample_visible_normal(wo, at.alpha, u);
        const Vec3 wi = ggx::reflect(wo, m);
        if (wi.z <= 0)
            return {};
        const float masking = ggx::masking(wo, at.alpha);
        return {wi,
                fresnel_schlick(wo.dot(m), at.color) * gain(at, wo.z) *
                    (ggx::shadowing(wo, wi, at.alpha) / masking),
                masking * ggx::density(m, at.alpha) / (4 * wo.z)};
    }

  private:
    // Energy of the further bounces between facets, in proportion to the first (Turquin 2019,
    // eq. 16).
    static Color gain(const Bsdf& at, float cosine) {
        const float single = at.albedo.at(cosine);
        return Color(1.0F, 1.0F, 1.0F) + at.color * ((1 - single) / single);
    }
};

class PreparedMetal final : public PreparedMaterial {
  public:
    PreparedMetal(const Metal& metal, AlbedoTables& tables)
        : PreparedMaterial(metal.paint),
          facets_(metal.roughness, AlbedoTable::mirror, metal.paint, tables) {}

    Bsdf bsdf(const Painted& painted, bool /*outside*/) const override {
        return facets_.bsdf(lobe_, painted, 1);
    }

  private:
    MetalLobe lobe_;
    GgxRoughness facets_;
};

} // namespace

std::unique_ptr<const PreparedMaterial> Metal::prepare(AlbedoTables& tables) const {
    return std::make_unique<const PreparedMetal>(*this, tables);
}

} // namespace scree
