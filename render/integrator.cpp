// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/integrator.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

// Russian roulette starts here: the first bounces carry most of the light of typical scenes
// (Pharr, Jakob & Humphreys 2016, section 14.5.4).
constexpr int first_roulette_edge = 4;

// Shadow rays end this share of their way before the light, so as not to meet it.
constexpr float before_light = 1 - 0x1p-12F;

float power_heuristic(float a, float b) { // Veach 1997, eq. 9.13 with beta = 2
    const float ratio = b / a;
    return 1 / (1 + ratio * ratio);
}

float largest(const Color& c) { return std::max({c.x, c.y, c.z}); }
bool black(const Color& c) { return c.x == 0 && c.y == 0 && c.z == 0; }

} // namespace

struct Integrator::Path {
    Ray ray;
    Color throughput{1.0F, 1.0F, 1.0F};
    Color radiance{0.0F, 0.0F, 0.0F};
    Color absorption{0.0F, 0.0F, 0.0F}; // of the glass around, if any [1/m]
    Vec3 point;                         // where the ray was scattered
    float pdf = 0;                      // of its direction
    bool delta = true;                  // its direction cannot be found by light sampling
    bool absorbing = false;
    int edges = 1; // of the path up to the ray's end
    int bounce = 0;
};

Integrator::Integrator(const World& world, std::span<const Material> materials,
                       std::span<const Light> lights, int depth, float clamp, Mis mis)
    : world_(world), materials_(materials), lights_(lights, mis == Mis::both), depth_(depth),
      clamp_(clamp), mis_(mis) {
    assert(world.material_count() <= materials.size());
}

void Integrator::add(Path& path, const Color& contribution, int edges) const {
    const Color light = path.throughput * contribution;
    const float value = largest(light);
    const bool too_bright = clamp_ > 0 && edges > 2 && value > clamp_;
    path.radiance += too_bright ? light * (clamp_ / value) : light;
}

float Integrator::hit_weight(const Path& path, float light_pdf) const {
    if (path.delta || mis_ == Mis::bsdf_only || light_pdf == 0)
        return 1;
    return mis_ == Mis::light_only ? 0 : power_heuristic(path.pdf, light_pdf);
}

void Integrator::add_escaped(Path& path) const {
    lights_.at_infinity(path.point, path.ray.direction, [&](const Color& radiance, float pdf) {
        if (!black(radiance))
            add(path, radiance * hit_weight(path, pdf), path.edges);
    });
}

void Integrator::add_light(Path& path, const Hit& hit) const {
    float pdf = 0;
    // The density is that of the way from the scattering point, not from the ray's offset origin.
    const Color radiance =
        lights_.area(hit.light, path.point, path.ray.direction, hit.distance, pdf);
    if (!black(radiance))
        add(path, radiance * hit_weight(path, pdf), path.edges);
}

void Integrator::add_direct(Path& path, const Hit& hit, const Surface& surface,
                            const Sampler& sampler, float choice, RayCount& count) const {
    const Vec2f u =
        sampler.pair(dimension::at(static_cast<std::uint32_t>(path.bounce), dimension::light));
    const LightSample light = lights_.sample(hit.position, choice, u);
    if (!(light.pdf > 0) || black(light.radiance))
        return;
    const BsdfValue bsdf = surface.evaluate(light.direction);
    if (black(bsdf.value))
        return;
    Ray shadow = hit.leave(light.direction);
    shadow.length = light.distance * before_light;
    ++count.rays;
    if (world_.occluded(shadow, count.clock))
        return;
    const float weight = mis_ == Mis::both ? power_heuristic(light.pdf, bsdf.pdf) : 1.0F;
    add(path, bsdf.value * light.radiance * (weight / light.pdf), path.edges + 1);
}

PathSample Integrator::trace(const CameraRay& camera_ray, float spread, const Sampler& sampler,
                             RayCount& count) const {
    PathSample result;
    Path path;
    path.ray = {camera_ray.origin, camera_ray.direction};
    path.point = camera_ray.origin;
    float way = 0;
    Hit hit;
    for (;; ++path.edges, ++path.bounce) {
        ++count.rays;
        if (!world_.hit(path.ray, hit, count.clock)) {
            add_escaped(path);
            break;
        }
        way += hit.distance;
        if (path.absorbing)
            for (int i = 0; i < 3; ++i)
                path.throughput[i] *= std::exp(-path.absorption[i] * hit.distance);
        if (path.edges == 1) {
            result.covered = true;
            result.position = hit.position;
            result.distance = hit.distance;
            result.instance = hit.instance;
            result.normal = hit.shading_normal;
        }
        if (hit.light != Hit::none) {
            add_light(path, hit);
            break;
        }
        if (path.edges >= depth_ && path.edges > 1)
            break;
        const Surface surface = materials_.surface(hit, path.ray.direction, spread * way);
        if (path.edges == 1) {
            result.albedo = surface.albedo();
            result.normal = surface.frame.z;
        }
        if (path.edges >= depth_)
            break;
        const auto bounce = static_cast<std::uint32_t>(path.bounce);
        const Vec2f choice = sampler.pair(dimension::at(bounce, dimension::choice));
        if (mis_ != Mis::bsdf_only && !lights_.empty() && !surface.bsdf.delta())
            add_direct(path, hit, surface, sampler, choice.x, count);
        const BsdfSample scattered =
            surface.sample(choice.y, sampler.pair(dimension::at(bounce, dimension::direction)));
        if (!(scattered.pdf > 0))
            break;
        path.throughput *= scattered.weight;
        if (path.edges >= first_roulette_edge) {
            const float survival = std::min(1.0F, largest(path.throughput));
            if (sampler.pair(dimension::at(bounce, dimension::roulette)).x >= survival)
                break;
            path.throughput /= survival;
        } else if (black(path.throughput)) {
            break;
        }
        if (scattered.transmitted) {
            path.absorption = surface.outside ? surface.inside : Color(0.0F, 0.0F, 0.0F);
            path.absorbing = !black(path.absorption);
        }
        path.pdf = scattered.pdf;
        path.delta = scattered.delta;
        path.point = hit.position;
        path.ray = hit.leave(scattered.direction);
    }
    result.radiance = path.radiance;
    return result;
}

} // namespace scree
