// SPDX-License-Identifier: GPL-3.0-or-later
// Materials made ready, and a hit turned into something that scatters light.
#pragma once

#include "core/frame.h"
#include "model/material.h"
#include "render/bsdf/bsdf.h"
#include "render/paint.h"
#include "render/subsurface.h"
#include "render/world/world.h"

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace scree {

/// A point of a surface as seen from one direction.
struct Surface {
    Bsdf bsdf;
    Frame frame{Vec3(0.0F, 0.0F, 1.0F)}; // of the shading normal, on the viewer's side
    Vec3 normal;                         // geometric, on the viewer's side
    Vec3 wo;                             // towards the viewer, in the frame
    Color inside{0.0F, 0.0F, 0.0F};      // absorption behind a glass surface [1/m]
    bool outside = true;                 // the viewer is on the outer side
    bool smooth = false;                 // shading and geometric normal differ

    /// For a direction in the world. Light that only the shading normal would let through is none.
    BsdfValue evaluate(const Vec3& wi) const;

    /// Answers a direction in the world.
    BsdfSample sample(float choice, const Vec2f& u) const;

    /// Shows what the colour is before light and angle: for the albedo picture.
    Color albedo() const;

  private:
    float terminator(const Vec3& wi, const Vec3& local) const;
};

/// The scene's materials. Thread-safe once made.
class MaterialSet {
  public:
    explicit MaterialSet(std::span<const std::shared_ptr<const Material>> materials);

    /// What the surface at a hit is painted with.
    const Paint& paint(const Hit& hit) const { return materials_[hit.material].paint; }

    /// The surface at a hit that was reached along `direction`, painted so.
    Surface surface(const Hit& hit, const Vec3& direction, const Painted& painted) const;

    /// A translucent surface as light sees it that goes out along `direction`.
    Surface emerging(const Hit& hit, const Vec3& direction, const Painted& painted) const;

    /// What is under the surface of a hit where its colour is `color`; translucent ones only.
    Medium medium(const Hit& hit, const Color& color) const;

    std::size_t size() const { return materials_.size(); }

  private:
    struct Prepared {
        BsdfKind kind = BsdfKind::matte;
        Paint paint;
        float alpha = 0;
        float ior = 1;
        Color absorption{0.0F, 0.0F, 0.0F};
        Color distance{0.0F, 0.0F, 0.0F};
        Albedo albedo;
        const RoughnessTables* varied = nullptr; // of a procedural, which may give a roughness
    };
    void prepare_lobe(Prepared& prepared, float roughness, float facet_ior);

    std::vector<Prepared> materials_;
    std::map<std::pair<float, float>, AlbedoTable> tables_; // by (alpha, ior)
    std::map<float, RoughnessTables> varied_tables_;        // by ior
};

} // namespace scree
