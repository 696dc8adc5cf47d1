// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <algorithm>
#include <array>
#include <limits>

namespace scree {

/// A triangle prepared for many distances and nearest points.
class DistanceTriangle {
  public:
    explicit DistanceTriangle(const std::array<Vec3, 3>& corners)
        : a_(corners[0]), ab_(corners[1] - corners[0]), ac_(corners[2] - corners[0]),
          bb_(ab_.dot(ab_)), bc_(ab_.dot(ac_)), cc_(ac_.dot(ac_)),
          determinant_(bb_ * cc_ - bc_ * bc_), inverse_bb_(inverse(bb_)), inverse_cc_(inverse(cc_)),
          inverse_opposite_(inverse((ab_ - ac_).length2())),
          inverse_determinant_(inverse(determinant_)) {}

    /// The point of the triangle that is nearest to p.
    Vec3 nearest(const Vec3& p) const {
        const Vec3 ap = p - a_;
        const float pb = ab_.dot(ap);
        const float pc = ac_.dot(ap);
        const float v = cc_ * pb - bc_ * pc;
        const float w = bb_ * pc - bc_ * pb;
        if (v >= 0 && w >= 0 && v + w <= determinant_ && inverse_determinant_ > 0)
            return a_ + ab_ * (v * inverse_determinant_) + ac_ * (w * inverse_determinant_);
        // Outside: on one of the sides.
        const Vec3 on_ab = a_ + ab_ * share(pb * inverse_bb_);
        const Vec3 on_ac = a_ + ac_ * share(pc * inverse_cc_);
        const Vec3 cb = ab_ - ac_;
        const Vec3 on_bc = a_ + ac_ + cb * share(cb.dot(ap - ac_) * inverse_opposite_);
        const float to_ab = (p - on_ab).length2();
        const float to_ac = (p - on_ac).length2();
        const float to_bc = (p - on_bc).length2();
        return to_ab <= to_ac && to_ab <= to_bc ? on_ab : to_ac <= to_bc ? on_ac : on_bc;
    }

    float distance2(const Vec3& p) const { return (p - nearest(p)).length2(); }

  private:
    static float share(float along) { return std::clamp(along, 0.0F, 1.0F); }
    static float inverse(float x) { // 0 where there is none
        return x > std::numeric_limits<float>::min() ? 1 / x : 0;
    }

    Vec3 a_, ab_, ac_;
    float bb_, bc_, cc_, determinant_;
    float inverse_bb_, inverse_cc_, inverse_opposite_, inverse_determinant_;
};

} // namespace scree
