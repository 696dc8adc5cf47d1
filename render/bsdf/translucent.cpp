// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/ggx_roughness.h"
#include "render/bsdf/prepared_material.h"
#include "render/bsdf/translucent_lobes.h"

namespace scree {

namespace {

class PreparedTranslucent final : public PreparedMaterial, public Subsurface {
  public:
    PreparedTranslucent(const Translucent& translucent, AlbedoTables& tables)
        : PreparedMaterial(translucent.paint),
          roughness_(translucent.roughness, translucent.ior, translucent.paint, tables),
          ior_(translucent.ior), distance_(translucent.distance) {}

    Bsdf bsdf(const Painted& painted, bool /*outside*/) const override {
        return roughness_.bsdf(coat_, painted, ior_);
    }

    const Subsurface* subsurface() const override { return this; }
    Medium medium(const Color& color) const override { return make_medium(color, distance_); }
    Bsdf emerging(const Painted& painted) const override {
        return roughness_.bsdf(emerging_, painted, ior_);
    }

  private:
    CoatLobe coat_;
    EmergingLobe emerging_;
    GgxRoughness roughness_; // of the coat
    float ior_;
    Color distance_;
};

} // namespace

std::unique_ptr<const PreparedMaterial> Translucent::prepare(AlbedoTables& tables) const {
    return std::make_unique<const PreparedTranslucent>(*this, tables);
}

} // namespace scree
