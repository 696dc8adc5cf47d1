// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/light/area_sampler.h"

#include <algorithm>

namespace scree {

AreaSampler::AreaSampler(const AreaLight& light)
    : light_(light), radiance_(light.radiance), normal_(light.normal()),
      area_(light.edge_u.cross(light.edge_v).length()) {}

float AreaSampler::pdf(const Vec3& direction, float distance) const {
    const float cosine = -direction.dot(normal_);
    return cosine > 0 ? distance * distance / (cosine * area_) : 0;
}

LightSample AreaSampler::sample(const Vec3& point, const Vec2f& u) const {
    const Vec3 target =
        Vec3(light_.centre) + light_.edge_u * (u.x - 0.5F) + light_.edge_v * (u.y - 0.5F);
    const Vec3 way = target - point;
    const float distance = std::sqrt(way.dot(way));
    LightSample sample;
    if (!(distance > 0))
        return sample;
    sample.direction = way / distance;
    sample.distance = distance;
    sample.pdf = pdf(sample.direction, distance);
    sample.radiance = radiance(sample.direction);
    return sample;
}

float AreaSampler::irradiance(const Vec3& point) const {
    const Vec3 way = Vec3(light_.centre) - point;
    const float height = -way.dot(normal_); // above the light's plane
    if (!(height > 0))
        return 0;
    // That of a point light at its centre, but never more than a hemisphere of light would give.
    const float square = way.dot(way);
    const float cosine = height / std::sqrt(square);
    return luminance(radiance_) * std::min(pi_f, area_ * cosine / square);
}

} // namespace scree
