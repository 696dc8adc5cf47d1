// SPDX-License-Identifier: GPL-3.0-or-later
// A dielectric interface, smooth (Fresnel) or rough (Walter et al. 2007). It carries radiance over
// the square of the index of refraction, which refraction keeps: with eye and lights in air the
// factors of Walter's eq. 21 cancel along every path.
#pragma once

#include "render/bsdf/bsdf.h"

namespace scree::glass {

BsdfSample sample_smooth(const Vec3& wo, float choice, float eta);
BsdfSample sample_rough(const Vec3& wo, float choice, const Vec2f& u, float alpha, float eta);
BsdfValue evaluate(const Vec3& wo, const Vec3& wi, float alpha, float eta);

} // namespace scree::glass
