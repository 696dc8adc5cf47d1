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

LightSampler::LightSampler(std::span<const Light> lights, bool compensate)
    : area_of_(lights.size()) {
    std::vector<AreaSampler> areas;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (const auto* area = std::get_if<AreaLight>(&lights[i])) {
            area_of_[i] = static_cast<std::uint32_t>(areas.size());
            area_number_.push_back(static_cast<std::uint32_t>(i));
            areas.emplace_back(*area);
            continue;
        }
        if (const auto* sky = std::get_if<Sky>(&lights[i]))
            infinite_.emplace_back(SkySampler(*sky, compensate));
        else
            infinite_.emplace_back(SunSampler(std::get<Sun>(lights[i])));
        infinite_number_.push_back(static_cast<std::uint32_t>(i));
        infinite_weight_ += infinite_weight(infinite_.size() - 1);
    }
    areas_ = LightTree(areas);
    empty_ = areas.empty() && !(infinite_weight_ > 0);
}

float LightSampler::infinite_weight(std::size_t light) const {
    if (const auto* sun = std::get_if<SunSampler>(&infinite_[light]))
        return sun->irradiance();
    return std::get<SkySampler>(infinite_[light]).irradiance();
}

LightSample LightSampler::sample_infinite(float left, const Vec2f& u, float total) const {
    std::size_t chosen = 0;
    float chosen_weight = 0;
    for (std::size_t i = 0; i < infinite_.size(); ++i) {
        const float w = infinite_weight(i);
        if (w > 0) { // by rounding, `left` may exceed the last one's weight
            chosen = i;
            chosen_weight = w;
            if (left < w)
                break;
        }
        left -= w;
    }
    LightSample sample;
    sample.light = infinite_number_[chosen];
    sample.distance = std::numeric_limits<float>::infinity();
    if (const auto* sun = std::get_if<SunSampler>(&infinite_[chosen])) {
        sample.direction = sun->sample(u);
        sample.pdf = sun->pdf(sample.direction);
        sample.radiance = sun->radiance(sample.direction);
    } else {
        const auto& sky = std::get<SkySampler>(infinite_[chosen]);
        sample.direction = sky.sample(u, sample.pdf);
        sample.radiance = sky.radiance(sample.direction);
    }
    sample.pdf *= chosen_weight / total;
    return sample;
}

LightSample LightSampler::sample(const Vec3& point, float choice, const Vec2f& u) const {
    const float area_weight = areas_.irradiance(point);
    const float total = infinite_weight_ + area_weight;
    if (!(total > 0))
        return {};
    const float left = choice * total;
    if (left < infinite_weight_ || !(area_weight > 0))
        return sample_infinite(left, u, total);
    const float rest = std::min((left - infinite_weight_) / area_weight, 1 - 0x1p-24F);
    const LightTree::Choice chosen = areas_.choose(point, rest);
    if (!(chosen.probability > 0))
        return {};
    LightSample sample = areas_.light(chosen.light).sample(point, u);
    sample.light = area_number_[chosen.light];
    sample.pdf *= chosen.probability * area_weight / total;
    return sample;
}

Color LightSampler::area(std::uint32_t light, const Vec3& point, const Vec3& direction,
                         float distance, float& pdf) const {
    const std::uint32_t index = area_of_[light];
    const AreaSampler& area = areas_.light(index);
    pdf = 0;
    const float probability = areas_.probability(index, point);
    if (probability > 0)
        pdf = area.pdf(direction, distance) * probability * areas_.irradiance(point) /
              total_weight(point);
    return area.radiance(direction);
}

} // namespace scree
