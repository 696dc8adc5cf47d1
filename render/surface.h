// SPDX-License-Identifier: GPL-3.0-or-later
// Materials made ready, and a hit turned into something that scatters light.
#pragma once

#include "core/frame.h"
#include "render/bsdf/prepared_material.h"
#include "render/world/world.h"

#include <memory>
#include <span>
#include <vector>

namespace scree {

/// A point of a surface as seen from one direction.
struct Surface {
    Bsdf bsdf;
    const PreparedMaterial* material = nullptr;
    Frame frame{Vec3(0.0F, 0.0F, 1.0F)}; // of the shading normal, on the viewer's side
    Vec3 normal{0.0F, 0.0F, 0.0F};       // geometric, on the viewer's side
    Vec3 wo{0.0F, 0.0F, 0.0F};           // towards the viewer, in the frame
    bool outside = true;                 // the viewer is on the outer side
    bool smooth = false;                 // shading and geometric normal differ

    /// For a direction in the world. Zero for light that the shading normal would let through and
    /// the geometric normal would not, or the other way round.
    BsdfValue evaluate(const Vec3& wi) const;

    /// Answers a direction in the world.
    BsdfSample sample(float choice, const Vec2f& u) const;

  private:
    float terminator(const Vec3& wi, const Vec3& local) const;
};

/// The scene's materials. Thread-safe once made.
class MaterialSet {
  public:
    /// `least_roughness` is that of rough surfaces; 0: they are as they are.
    explicit MaterialSet(std::span<const std::shared_ptr<const Material>> materials,
                         float least_roughness = 0);

    /// The material at a hit.
    const PreparedMaterial& at(const Hit& hit) const { return *materials_[hit.material]; }

    /// The surface at a hit that was reached along `direction`, painted so. `rough`: with facets of
    /// the least roughness or more.
    Surface surface(const Hit& hit, const Vec3& direction, const Painted& painted,
                    bool rough = false) const;

    /// The surface at a hit that light reached along `direction` from under it; of a material with
    /// a subsurface.
    Surface emerging(const Hit& hit, const Vec3& direction, const Painted& painted) const;

  private:
    AlbedoTables tables_;
    float least_roughness_;
    std::vector<std::unique_ptr<const PreparedMaterial>> materials_;
    std::vector<std::unique_ptr<const PreparedMaterial>> rough_; // none without a least roughness
};

} // namespace scree
