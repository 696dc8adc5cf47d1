// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/warps.h"
#include "render/bsdf/prepared_material.h"

namespace scree {

namespace {

/// Lambert 1760.
class LambertLobe final : public Lobe {
  public:
    LambertLobe() : Lobe({.diffuse = true}) {}

    BsdfValue evaluate(const Bsdf& at, const Vec3& /*wo*/, const Vec3& wi,
                       float diffuse_scale) const override {
        const float pdf = wi.z / pi_f;
        return {at.color * (diffuse_scale * pdf), pdf};
    }

    BsdfSample sample(const Bsdf& at, const Vec3& /*wo*/, float /*choice*/,
                      const Vec2f& u) const override {
        const Vec3 wi = warp::cosine_hemisphere(u);
        return {wi, at.color, wi.z / pi_f};
    }
};

} // namespace

std::unique_ptr<const PreparedMaterial> Matte::prepare(AlbedoTables& /*tables*/) const {
    return std::make_unique<const ColoredLobe<LambertLobe>>(paint);
}

} // namespace scree
