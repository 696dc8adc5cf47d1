// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include "core/error.h"
#include "core/warps.h"

namespace scree {

WideVec3 world_origin(const Camera& camera) {
    constexpr double step = 16; // [m]; at half of it a float is exact to half a micrometre
    WideVec3 origin;
    for (int axis = 0; axis < 3; ++axis)
        origin[axis] = step * std::round(camera.from[axis] / step);
    return origin;
}

CameraRays::CameraRays(const Camera& camera, int width, int height, const WideVec3& origin)
    : from_(camera.from - origin) {
    const Vec3 view(camera.at - camera.from);
    if (!(is_finite(view) && view.length() > 0))
        throw Error("camera: `at` must differ from `from`");
    forward_ = view.normalized();
    const Vec3 right = forward_.cross(camera.up.normalized());
    if (!(right.length() > 1e-6F))
        throw Error("camera: `up` must not be parallel to the view direction");
    const Vec3 x = right.normalized();
    const Vec3 y = x.cross(forward_);
    const float half_height = std::tan(camera.fov / 2);
    spread_ = 2 * half_height / static_cast<float>(height);
    right_ = x * spread_;
    down_ = y * -spread_;
    corner_ = forward_ - right_ * (0.5F * static_cast<float>(width)) -
              down_ * (0.5F * static_cast<float>(height));
    pinhole_ = camera.aperture == 0;
    lens_x_ = x * (camera.aperture / 2);
    lens_y_ = y * (camera.aperture / 2);
    focus_ = camera.focus > 0 ? camera.focus : view.length();
}

CameraRay CameraRays::ray(float x, float y, const Vec2f& lens) const {
    const Vec3 through = corner_ + right_ * x + down_ * y;
    if (pinhole_)
        return {from_, through.normalized()};
    const Vec2f disk = warp::disk(lens);
    const Vec3 offset = lens_x_ * disk.x + lens_y_ * disk.y;
    return {from_ + offset, (through * focus_ - offset).normalized()};
}

} // namespace scree
