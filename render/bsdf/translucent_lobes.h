// SPDX-License-Identifier: GPL-3.0-or-later
// The coat of a translucent thing: light on its way in, and on its way out.
#pragma once

#include "render/bsdf/bsdf.h"

namespace scree {

/// The coat alone, which reflects light or lets it in. What it lets in comes out through an
/// EmergingLobe.
class CoatLobe final : public Lobe {
  public:
    CoatLobe() : Lobe({.mirrors = true}) {}
    BsdfValue evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi,
                       float diffuse_scale) const override;
    BsdfSample sample(const Bsdf& at, const Vec3& wo, float choice, const Vec2f& u) const override;
};

/// Light that comes out through the coat, as much of it as the base of a plastic gives.
class EmergingLobe final : public Lobe {
  public:
    EmergingLobe() : Lobe({.diffuse = true, .mirrors = true}) {}
    BsdfValue evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi,
                       float diffuse_scale) const override;
};

} // namespace scree
