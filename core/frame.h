// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

namespace scree {

/// An orthonormal basis around a unit vector (Duff et al. 2017).
struct Frame {
    Vec3 x;
    Vec3 y;
    Vec3 z;

    explicit Frame(const Vec3& n) : z(n) {
        const float sign = std::copysign(1.0F, n.z);
        const float a = -1.0F / (sign + n.z);
        const float b = n.x * n.y * a;
        x = {1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x};
        y = {b, sign + n.y * n.y * a, -n.y};
    }

    /// With x as near to `tangent` as it can be; any x where the two are parallel, or `tangent` is
    /// 0.
    Frame(const Vec3& n, const Vec3& tangent) : Frame(n) {
        const Vec3 level = tangent - n * n.dot(tangent);
        const float square = level.dot(level);
        if (!(square > 1e-12F))
            return;
        x = level / std::sqrt(square);
        y = n.cross(x);
    }

    Vec3 local_from_world(const Vec3& v) const { return {v.dot(x), v.dot(y), v.dot(z)}; }
    Vec3 world_from_local(const Vec3& v) const { return x * v.x + y * v.y + z * v.z; }
};

/// Normalises without the guard against underflow that Imath's normalized() has.
inline Vec3 unit(const Vec3& v) { return v / std::sqrt(v.dot(v)); }

} // namespace scree
