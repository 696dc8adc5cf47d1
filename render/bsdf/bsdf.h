// SPDX-License-Identifier: GPL-3.0-or-later
// How one point of a surface scatters light. Directions are in the frame of its shading normal (z),
// which is on the side of the viewer: wo.z > 0 always.
#pragma once

#include "core/math.h"
#include "render/bsdf/albedo_table.h"

namespace scree {

/// Value of a BSDF for a pair of directions, and the density with which `sample` finds wi.
struct BsdfValue {
    Color value{0.0F, 0.0F, 0.0F}; // BSDF times |cos wi|
    float pdf = 0;                 // per solid angle
};

/// One scattered direction.
struct BsdfSample {
    Vec3 direction{0.0F, 0.0F, 0.0F}; // wi
    Color weight{0.0F, 0.0F, 0.0F};   // BSDF times |cos wi| over pdf
    float pdf = 0;                    // per solid angle; 0: the light is lost
    bool delta = false;               // sampling lights cannot find it; then pdf means nothing
    bool transmitted = false;
};

struct Bsdf;

/// What holds for a lobe wherever it is.
struct LobeTraits {
    bool delta = false;   // scatters into single directions only, which sampling lights cannot find
    bool diffuse = false; // `diffuse_scale` changes its value
    bool two_sided = false; // `evaluate` also takes directions below the surface
    bool oriented = false;  // the frame's x must follow the tangent
    // Where a shading normal would send the viewer's mirror image below the surface, it is bent
    // until it does not.
    bool mirrors = false;
    // Light that goes below the surface has left the whole thing again on its other side.
    bool goes_through = false;
};

/// A way to scatter light: one object, shared by all the places that do so. What differs from place
/// to place is in the Bsdf. Thread-safe.
class Lobe {
  public:
    /// `wo` is above the surface, `wi` too unless the lobe is two_sided. Zero for a delta lobe.
    /// `diffuse_scale` multiplies the diffuse part of the value.
    virtual BsdfValue evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi,
                               float diffuse_scale) const = 0;

    /// `choice` chooses between its parts, `u` a direction within; all uniform in [0, 1). The
    /// default is for lobes whose density is that of the cosine over the hemisphere.
    virtual BsdfSample sample(const Bsdf& at, const Vec3& wo, float choice, const Vec2f& u) const;

    const LobeTraits& traits() const { return traits_; }

  protected:
    explicit Lobe(const LobeTraits& traits = {}) : traits_(traits) {}
    ~Lobe() = default;

  private:
    LobeTraits traits_;
};

/// A lobe at one place of a surface. Small and flat: made for every hit.
struct Bsdf {
    const Lobe* lobe = nullptr;    // outlives it
    Color color{0.0F, 0.0F, 0.0F}; // reflectance; white for glass
    float alpha = 0;               // GGX
    float eta = 1;                 // index of refraction of the far side to the viewer's
    Albedo albedo{};               // of the coat, or of the metal's facets

    bool delta() const { return lobe->traits().delta; }

    BsdfValue evaluate(const Vec3& wo, const Vec3& wi, float diffuse_scale = 1) const {
        if (!(wo.z > 0) || !(wi.z > 0 || lobe->traits().two_sided))
            return {};
        return lobe->evaluate(*this, wo, wi, diffuse_scale);
    }

    BsdfSample sample(const Vec3& wo, float choice, const Vec2f& u) const {
        return wo.z > 0 ? lobe->sample(*this, wo, choice, u) : BsdfSample{};
    }
};

} // namespace scree
