// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/chromaticities.h"

#include "core/error.h"

namespace scree {

namespace {

using Imath::M33d;
using Imath::V3d;

V3d xyz_of(const Vec2& xy) {
    if (!(xy.y > 0 && std::abs(xy.x) < 10 && xy.y < 10))
        throw Error("its chromaticities are impossible: y must be above 0");
    return {xy.x / xy.y, 1.0, (1 - xy.x - xy.y) / xy.y};
}

M33d rows(const V3d& a, const V3d& b, const V3d& c) {
    return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
}

M33d diagonal(const V3d& v) { return {v.x, 0, 0, 0, v.y, 0, 0, 0, v.z}; }

/// From one white to another: the responses of cones are scaled (Lam 1985).
M33d adapted(const V3d& from, const V3d& to) {
    const M33d cones =
        M33d(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296)
            .transposed();
    return cones * diagonal(to * cones / (from * cones)) * cones.inverse();
}

Imath::M33f rec709(const M33d& xyz, const V3d& white) {
    static const Chromaticities own;
    return Imath::M33f(xyz * adapted(white, xyz_of(own.white)) * xyz_from_rgb(own).inverse());
}

} // namespace

M33d xyz_from_rgb(const Chromaticities& primaries) {
    const M33d full = rows(xyz_of(primaries.red), xyz_of(primaries.green), xyz_of(primaries.blue));
    if (std::abs(full.determinant()) < 1e-9)
        throw Error("its chromaticities are impossible: the primaries lie on a line");
    return diagonal(xyz_of(primaries.white) * full.inverse()) * full;
}

Imath::M33f rec709_from(const Chromaticities& primaries) {
    return rec709(xyz_from_rgb(primaries), xyz_of(primaries.white));
}

Imath::M33f rec709_from_xyz(const V3d& white) { return rec709(M33d(), white); }

} // namespace scree
