// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/camera.h"

namespace scree {

/// A ray leaving the camera.
struct CameraRay {
    Vec3 origin;
    Vec3 direction; // unit length
};

/// An origin near the camera for its world: its eye to the nearest 16 m along each axis, so that
/// it is the scene's own in a scene that lies about there.
WideVec3 world_origin(const Camera& camera);

/// The camera made ready for pictures of one size.
class CameraRays {
  public:
    /// Rays are relative to `origin` (see World). Throws Error (input) when `from` and `at`
    /// coincide or `up` is parallel to the view.
    CameraRays(const Camera& camera, int width, int height, const WideVec3& origin = WideVec3(0));

    /// Ray through the raster point (x, y) in pixels, y downwards, (0, 0) the top left corner;
    /// `lens` is uniform in [0, 1)^2.
    CameraRay ray(float x, float y, const Vec2f& lens) const;

    /// Depth of a point along the view direction [m].
    float depth(const Vec3& p) const { return (p - from_).dot(forward_); }

    /// Width of a pixel at unit distance along a ray [m/m].
    float pixel_spread() const { return spread_; }

  private:
    Vec3 from_;
    Vec3 right_;   // one pixel to the right on the plane at unit distance
    Vec3 down_;    // one pixel down
    Vec3 corner_;  // direction to the top left corner at unit distance
    Vec3 forward_; // unit
    Vec3 lens_x_;  // lens radius along the picture's axes
    Vec3 lens_y_;
    bool pinhole_ = true;
    float focus_ = 1;
    float spread_ = 0;
};

} // namespace scree
