// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/pose.h"

#include <algorithm>

namespace scree {

namespace {

constexpr double least_angle = 1e-9; // [rad]; less is no rotation

} // namespace

Rotation::Rotation(const Imath::V3d& vector) {
    const double angle = vector.length();
    if (angle <= least_angle)
        return;
    axis_ = vector.normalized();
    cosine_ = std::cos(angle);
    sine_ = std::sin(angle);
}

Imath::V3d Rotation::operator()(const Imath::V3d& v) const { // Rodrigues' formula
    return v * cosine_ + axis_.cross(v) * sine_ + axis_ * (axis_.dot(v) * (1 - cosine_));
}

Imath::M33f Rotation::operator()(const Imath::M33f& rows) const {
    if (sine_ == 0)
        return rows;
    const Imath::M33d m(rows);
    const Imath::V3d x = (*this)(Imath::V3d(m[0][0], m[0][1], m[0][2])).normalized();
    Imath::V3d y = (*this)(Imath::V3d(m[1][0], m[1][1], m[1][2]));
    y = (y - x * x.dot(y)).normalized();
    const Imath::V3d z = x.cross(y);
    return Imath::M33f(Imath::M33d(x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z));
}

double angle_between(const Imath::M33f& a, const Imath::M33f& b) {
    double trace = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            trace += double(a[i][k]) * double(b[i][k]);
    return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0));
}

} // namespace scree
