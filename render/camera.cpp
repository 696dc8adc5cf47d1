// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include "core/error.h"

namespace scree {

namespace {

// Sine and cosine for |x| <= pi / 4 by their Taylor series, whose next terms are below 2^-24 there:
// no call, and the same bits whatever the C library.
void sine_cosine(float x, float& sine, float& cosine) {
    const float x2 = x * x;
    sine = x * (1 + x2 * (-1.0F / 6 + x2 * (1.0F / 120 + x2 * (-1.0F / 5040 + x2 / 362880))));
    cosine = 1 + x2 * (-0.5F + x2 * (1.0F / 24 + x2 * (-1.0F / 720 + x2 / 40320)));
}

} // namespace

Vec2f concentric_disk(const Vec2f& u) {
    const float a = 2 * u.x - 1;
    const float b = 2 * u.y - 1;
    if (a == 0 && b == 0)
        return {0.0F, 0.0F};
    // Which half of the wedges it is falls at random, so no branch.
    const bool steep = std::abs(b) >= std::abs(a);
    const float radius = steep ? b : a;
    constexpr auto quarter = static_cast<float>(pi / 4);
    float sine = 0;
    float cosine = 0;
    sine_cosine(quarter * ((steep ? a : b) / radius), sine, cosine);
    return {radius * (steep ? sine : cosine), radius * (steep ? cosine : sine)};
}

CameraRays::CameraRays(const Camera& camera, int width, int height) : from_(camera.from) {
    const Vec3 view = camera.at - camera.from;
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
    const Vec2f disk = concentric_disk(lens);
    const Vec3 offset = lens_x_ * disk.x + lens_y_ * disk.y;
    return {from_ + offset, (through * focus_ - offset).normalized()};
}

} // namespace scree
