// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/ggx.h"
#include "render/bsdf/glass_lobes.h"
#include "render/bsdf/prepared_material.h"

namespace scree {

namespace {

/// Glass with an interface of one kind.
template <class L>
class PreparedGlass final : public PreparedMaterial {
  public:
    explicit PreparedGlass(const Glass& glass)
        : PreparedMaterial({}), absorption_(glass.absorption),
          alpha_(glass.roughness * glass.roughness), ior_(glass.ior) {}

    Bsdf bsdf(const Painted& /*painted*/, bool outside) const override {
        return {&lobe_, Color(1.0F, 1.0F, 1.0F), alpha_, outside ? ior_ : 1 / ior_};
    }

    Color absorption() const override { return absorption_; }

  private:
    L lobe_;
    Color absorption_;
    float alpha_;
    float ior_;
};

} // namespace

std::unique_ptr<const PreparedMaterial> Glass::prepare(AlbedoTables& /*tables*/) const {
    if (roughness * roughness < ggx::min_alpha)
        return std::make_unique<const PreparedGlass<SmoothGlassLobe>>(*this);
    return std::make_unique<const PreparedGlass<RoughGlassLobe>>(*this);
}

} // namespace scree
