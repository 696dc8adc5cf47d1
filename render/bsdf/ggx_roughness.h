// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/bsdf/ggx.h"
#include "render/bsdf/prepared_material.h"

namespace scree {

/// The roughness of a material's GGX facets: its own, or by place where its paint gives one.
class GgxRoughness {
  public:
    /// `roughness` is perceptual; `facet_ior` as in AlbedoTable. Whether roughness may go by place
    /// is up to `paint`. `tables` must outlive this.
    GgxRoughness(float roughness, float facet_ior, const Paint& paint, AlbedoTables& tables)
        : alpha_(ggx::alpha(roughness)), albedo_(&tables.at(alpha_, facet_ior)),
          by_place_(paint.texture.procedural != nullptr ? &tables.by_roughness(facet_ior)
                                                        : nullptr) {}

    /// `lobe` where the paint says this; `eta` as in Bsdf.
    Bsdf bsdf(const Lobe& lobe, const Painted& painted, float eta) const {
        if (painted.roughness >= 0 && by_place_ != nullptr)
            return {&lobe, painted.color, ggx::alpha(std::min(painted.roughness, 1.0F)), eta,
                    by_place_->at(painted.roughness)};
        return {&lobe, painted.color, alpha_, eta, albedo_};
    }

  private:
    float alpha_;
    const AlbedoTable* albedo_;
    const RoughnessTables* by_place_; // null: one roughness everywhere
};

} // namespace scree
