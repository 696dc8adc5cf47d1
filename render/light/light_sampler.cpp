// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/light/light_sampler.h"

#include "core/warps.h"

#include <algorithm>
#include <limits>

namespace scree {

SunSampler::SunSampler(const Sun& sun)
    : direction_(sun.direction.normalized()), frame_(direction_) {
    const double radius = double(sun.angle) / 2;
    const double half_sine = std::sin(radius / 2);
    const double sine = std::sin(radius);
    cap_ = static_cast<float>(2 * half_sine * half_sine);
    chord2_ = 2 * cap_;
    pdf_ = static_cast<float>(1 / (2 * pi * 2 * half_sine * half_sine));
    // A uniform cone gives pi L sin^2(radius) to the plane that faces it.
    radiance_ = sun.color * static_cast<float>(double(sun.strength) / (pi * sine * sine));
    irradiance_ = luminance(sun.color) * sun.strength;
}

bool SunSampler::inside(const Vec3& direction) const {
    const Vec3 chord = direction - direction_; // exact for small angles, unlike the cosine
    return chord.dot(chord) < chord2_;
}

Color SunSampler::radiance(const Vec3& direction) const {
    return inside(direction) ? radiance_ : Color(0.0F, 0.0F, 0.0F);
}

float SunSampler::pdf(const Vec3& direction) const { return inside(direction) ? pdf_ : 0; }

Vec3 SunSampler::sample(const Vec2f& u) const {
    return unit(frame_.world_from_local(warp::cap(u, cap_)));
}

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

LightSampler::LightSampler(std::span<const Light> lights, bool compensate) {
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        if (const auto* sky = std::get_if<Sky>(&lights[i]))
            lights_.emplace_back(SkySampler(*sky, compensate));
        else if (const auto* sun = std::get_if<Sun>(&lights[i]))
            lights_.emplace_back(SunSampler(*sun));
        else
            lights_.emplace_back(AreaSampler(std::get<AreaLight>(lights[i])));
        const bool area = std::holds_alternative<AreaSampler>(lights_.back());
        (area ? areas_ : infinite_).push_back(i);
        if (!area)
            infinite_weight_ += weight(i, {});
        if (area || weight(i, {}) > 0)
            ++sampled_count_;
    }
}

float LightSampler::weight(std::size_t light, const Vec3& point) const {
    if (const auto* area = std::get_if<AreaSampler>(&lights_[light]))
        return area->irradiance(point);
    if (const auto* sun = std::get_if<SunSampler>(&lights_[light]))
        return sun->irradiance();
    return std::get<SkySampler>(lights_[light]).irradiance();
}

float LightSampler::total_weight(const Vec3& point) const {
    float total = infinite_weight_;
    for (const std::uint32_t i : areas_)
        total += weight(i, point);
    return total;
}

LightSample LightSampler::sample(const Vec3& point, float choice, const Vec2f& u) const {
    const float total = total_weight(point);
    if (!(total > 0))
        return {};
    float left = choice * total;
    std::size_t chosen = lights_.size();
    float chosen_weight = 0;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const float w = weight(i, point);
        if (w > 0) { // by rounding, `left` may exceed the last one's weight
            chosen = i;
            chosen_weight = w;
            if (left < w)
                break;
        }
        left -= w;
    }
    LightSample sample;
    if (const auto* area = std::get_if<AreaSampler>(&lights_[chosen])) {
        sample = area->sample(point, u);
    } else {
        sample.distance = std::numeric_limits<float>::infinity();
        if (const auto* sun = std::get_if<SunSampler>(&lights_[chosen])) {
            sample.direction = sun->sample(u);
            sample.pdf = sun->pdf(sample.direction);
            sample.radiance = sun->radiance(sample.direction);
        } else {
            const auto& sky = std::get<SkySampler>(lights_[chosen]);
            sample.direction = sky.sample(u, sample.pdf);
            sample.radiance = sky.radiance(sample.direction);
        }
    }
    sample.pdf *= chosen_weight / total;
    return sample;
}

Color LightSampler::area(std::uint32_t light, const Vec3& point, const Vec3& direction,
                         float distance, float& pdf) const {
    const auto& area = std::get<AreaSampler>(lights_[light]);
    pdf = 0;
    const float w = area.irradiance(point);
    if (w > 0)
        pdf = area.pdf(direction, distance) * w / total_weight(point);
    return area.radiance(direction);
}

} // namespace scree
