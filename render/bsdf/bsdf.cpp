// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/bsdf.h"

#include "core/warps.h"

namespace scree {

BsdfSample Lobe::sample(const Bsdf& at, const Vec3& wo, float /*choice*/, const Vec2f& u) const {
    const Vec3 wi = warp::cosine_hemisphere(u);
    const BsdfValue value = evaluate(at, wo, wi, 1);
    return {wi, value.value / value.pdf, value.pdf};
}

} // namespace scree
