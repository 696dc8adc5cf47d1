// SPDX-License-Identifier: GPL-3.0-or-later
// Embree 3.13 (Debian 12) and 4.3 (Debian 13) behind the same functions; for render/world alone.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "core/math.h"

#include <memory>

namespace scree::embree {

/// What an instance takes and the memory monitor is not told [B]: Embree 4 tells all. The
/// difference to what the process grows by, `scree bench instances`.
inline constexpr std::int64_t unreported_bytes = RTC_VERSION_MAJOR >= 4 ? 0 : 290;

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using DeviceHandle = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using SceneHandle = std::unique_ptr<RTCSceneTy, ReleaseScene>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

/// `direction` may have any length; `length` is a multiple of it.
inline RTCRay make_ray(const Vec3& origin, const Vec3& direction, float length) {
    RTCRay ray;
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tnear = 0;
    ray.tfar = length;
    ray.time = 0;
    ray.mask = 0xffffffffU;
    ray.id = 0;
    ray.flags = 0;
    return ray;
}

inline Vec3 origin(const RTCRay& ray) { return {ray.org_x, ray.org_y, ray.org_z}; }
inline Vec3 direction(const RTCRay& ray) { return {ray.dir_x, ray.dir_y, ray.dir_z}; }

inline void intersect(RTCScene scene, RTCRayHit& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &ray, nullptr);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
}

inline void occluded(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray, nullptr);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
}

// The callbacks of user geometries. Scree traces single rays, so they get one at a time.

inline RTCRay& ray_of(const RTCIntersectFunctionNArguments& args) {
    return reinterpret_cast<RTCRayHit*>(args.rayhit)->ray;
}
inline RTCRay& ray_of(const RTCOccludedFunctionNArguments& args) {
    return *reinterpret_cast<RTCRay*>(args.ray);
}

#if RTC_VERSION_MAJOR < 4
/// A ray and its context, for as long as it is within an instance.
class Within {
  public:
    Within(RTCIntersectContext& context, RTCRay& ray, const RTCRay& within, unsigned instance)
        : context_(context), ray_(ray), origin_(origin(ray)), direction_(direction(ray)) {
        turn(origin(within), direction(within));
        context_.instID[0] = instance;
    }
    ~Within() {
        turn(origin_, direction_);
        context_.instID[0] = RTC_INVALID_GEOMETRY_ID;
    }
    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;

  private:
    void turn(const Vec3& origin, const Vec3& direction) {
        ray_.org_x = origin.x;
        ray_.org_y = origin.y;
        ray_.org_z = origin.z;
        ray_.dir_x = direction.x;
        ray_.dir_y = direction.y;
        ray_.dir_z = direction.z;
    }

    RTCIntersectContext& context_;
    RTCRay& ray_;
    Vec3 origin_;
    Vec3 direction_;
};
#endif

/// Lets the ray go on within an instance of the scene, in whose frame it is `within`; of that, only
/// the origin and the direction count. The callback must end with it.
inline void go_on(const RTCIntersectFunctionNArguments& args, RTCScene scene, RTCRay& within,
                  unsigned instance) {
#if RTC_VERSION_MAJOR >= 4
    rtcForwardIntersect1(&args, scene, &within, instance);
#else
    const Within held(*args.context, ray_of(args), within, instance);
    rtcIntersect1(scene, args.context, reinterpret_cast<RTCRayHit*>(args.rayhit));
#endif
}
inline void go_on(const RTCOccludedFunctionNArguments& args, RTCScene scene, RTCRay& within,
                  unsigned instance) {
#if RTC_VERSION_MAJOR >= 4
    rtcForwardOccluded1(&args, scene, &within, instance);
#else
    const Within held(*args.context, ray_of(args), within, instance);
    rtcOccluded1(scene, args.context, &ray_of(args));
#endif
}

/// Empty for an empty scene.
inline Box3 bounds(RTCScene scene) {
    RTCBounds box{};
    rtcGetSceneBounds(scene, &box);
    if (!(box.lower_x <= box.upper_x))
        return {};
    return {{box.lower_x, box.lower_y, box.lower_z}, {box.upper_x, box.upper_y, box.upper_z}};
}

} // namespace scree::embree
