// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface scatters light, in the frame of its shading normal (z), which is on the side of the
// viewer: wo.z > 0 always.
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
    Vec3 direction;                 // wi
    Color weight{0.0F, 0.0F, 0.0F}; // BSDF times |cos wi| over pdf
    float pdf = 0;                  // per solid angle; 0: the light is lost
    bool delta = false;             // not to be found by sampling lights; then pdf means nothing
    bool transmitted = false;
};

/// `translucent`: a coat that reflects or lets in; `emerging`: light on its way out through it.
enum class BsdfKind { matte, plastic, metal, smooth_glass, rough_glass, translucent, emerging };

/// A material at one point of a surface. Small and flat: no allocation, no virtual calls.
struct Bsdf {
    BsdfKind kind = BsdfKind::matte;
    Color color{0.0F, 0.0F, 0.0F}; // reflectance; of glass: unused
    float alpha = 0;               // GGX
    float eta = 1;                 // index of refraction of the far side to the viewer's
    Albedo albedo;                 // of the coat, or of the metal's facets

    bool delta() const { return kind == BsdfKind::smooth_glass; }

    /// Zero for a delta BSDF, and for light that goes into a translucent thing. `diffuse_scale`
    /// multiplies the diffuse part of the value.
    BsdfValue evaluate(const Vec3& wo, const Vec3& wi, float diffuse_scale = 1) const;

    /// `choice` chooses among lobes, `u` a direction within; all uniform in [0, 1).
    BsdfSample sample(const Vec3& wo, float choice, const Vec2f& u) const;
};

} // namespace scree
