// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/translucent_lobes.h"

namespace scree {

BsdfValue EmergingLobe::evaluate(const Bsdf& at, const Vec3& /*wo*/, const Vec3& wi,
                                 float diffuse_scale) const {
    const float pdf = wi.z / pi_f;
    const float value = diffuse_scale * (1 - at.albedo.at(wi.z)) / (1 - at.albedo.average()) * pdf;
    return {Color(value, value, value), pdf};
}

} // namespace scree
