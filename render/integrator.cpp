// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/integrator.h"

#include "render/subsurface.h"

#include <algorithm>
#include <array>

namespace scree {

namespace {

// Russian roulette starts here: the first bounces carry most of the light of typical scenes
// (Pharr, Jakob & Humphreys 2016, section 14.5.4).
constexpr int first_roulette_edge = 4;

// Paths that carry as much are always kept. With 1 in its place, 5,000 grey bunnies have 1.23 times
// the squared error for 0.975 of the rays.
constexpr float kept_throughput = 0.25F;

// A filter that is as wide as it is far away: 53 degrees.
constexpr float widest_spread = 1;

// Directions of a lower density [1/sr] come from a wide lobe: a diffuse one has up to 1 / pi. What
// they meet cannot be seen sharply, and narrow lobes there are found by chance alone: they are made
// wider if the film says so (Kaplanyan & Dachsbacher 2013, "Path space regularization").
constexpr float diffuse_density = 1;

// Shadow rays end at this share of the distance to the light, so as not to hit it.
constexpr float before_light = 1 - 0x1p-12F;

float power_heuristic(float a, float b) { // Veach 1997, eq. 9.13 with beta = 2
    const float ratio = b / a;
    return 1 / (1 + ratio * ratio);
}

std::uint32_t bounce_of(int edges) { return static_cast<std::uint32_t>(edges - 1); }

float largest(const Color& c) { return std::max({c.x, c.y, c.z}); }
bool black(const Color& c) { return c.x == 0 && c.y == 0 && c.z == 0; }

} // namespace

Integrator::Integrator(const World& world, const FilmSettings& settings, Mis mis)
    : world_(world), materials_(world.materials(), settings.regularise),
      lights_(world.lights(), mis == Mis::both), group_of_(light_groups(world.lights()).of),
      depth_(settings.depth), clamp_(settings.clamp), mis_(mis) {}

void Integrator::add(Path& path, const Color& contribution, int edges,
                     std::uint32_t light_number) const {
    const Color light = path.throughput_ * contribution;
    const float value = largest(light);
    const bool too_bright = clamp_ > 0 && edges > 2 && value > clamp_;
    const Color added = too_bright ? light * (clamp_ / value) : light;
    path.sample_.radiance += added;
    if (path.groups_ != nullptr)
        path.groups_[group_of_[light_number]] += added;
}

float Integrator::hit_weight(const Path& path, float light_pdf) const {
    if (path.delta_ || mis_ == Mis::bsdf_only || light_pdf == 0)
        return 1;
    return mis_ == Mis::light_only ? 0 : power_heuristic(path.pdf_, light_pdf);
}

void Integrator::add_escaped(Path& path) const {
    lights_.at_infinity(path.point_, path.ray_.direction,
                        [&](const Color& radiance, float pdf, std::uint32_t light) {
                            if (!black(radiance))
                                add(path, radiance * hit_weight(path, pdf), path.edges_, light);
                        });
}

void Integrator::add_light(Path& path, const Hit& hit) const {
    float pdf = 0;
    // Light sampling starts at the scattering point, not at the ray's offset origin.
    const Color radiance =
        lights_.area(hit.light, path.point_, path.ray_.direction, hit.distance, pdf);
    if (!black(radiance))
        add(path, radiance * hit_weight(path, pdf), path.edges_, hit.light);
}

void Integrator::add_direct(Path& path, const Hit& hit, const Surface& surface,
                            std::uint32_t bounce, float choice, RayCount& count) const {
    const Vec2f u = path.sampler_.pair(dimension::at(bounce, dimension::light));
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
    add(path, bsdf.value * light.radiance * (weight / light.pdf), path.edges_ + 1, light.light);
}

// Takes a path that has entered a translucent object to where it comes out.
void Integrator::walk(Path& path, RayCount& count) const {
    const std::uint32_t bounce = bounce_of(path.edges_);
    const float choice = path.sampler_.pair(dimension::at(bounce, dimension::roulette)).y;
    Random random(path.sampler_.key(), Purpose::subsurface_walk, bounce);
    const Medium medium = materials_.at(path.hit_).subsurface()->medium(path.color_);
    const Walk walk = walk_inside(world_, medium, path.hit_, path.ray_.direction, path.throughput_,
                                  choice, random, count.clock);
    count.rays += walk.rays;
    path.throughput_ *= walk.weight;
    if (walk.exit.found()) {
        path.found_ = walk.exit;
        path.ray_ = {walk.origin, walk.direction};
    } else {
        path.found_.distance = 0;
        path.ray_ = {path.hit_.position, -path.ray_.direction};
    }
}

// Adds the light emitted at the end of the path's ray; false unless light may be scattered there.
bool Integrator::arrive(Path& path) const {
    if (!path.found_.found()) {
        add_escaped(path);
        return false;
    }
    Hit& hit = path.hit_;
    world_.fill(path.ray_, path.found_, hit);
    path.width_ += path.spread_ * hit.distance;
    if (path.walking_)
        return !black(path.throughput_);
    if (path.absorbing_)
        for (int i = 0; i < 3; ++i)
            path.throughput_[i] *= std::exp(-path.absorption_[i] * hit.distance);
    const bool first = path.edges_ == 1;
    if (first) {
        path.sample_.covered = true;
        path.sample_.position = hit.position;
        path.sample_.distance = hit.distance;
        path.sample_.instance = hit.instance;
        path.sample_.material = hit.material;
        path.sample_.normal = hit.shading_normal;
    }
    if (hit.light != Hit::none) {
        add_light(path, hit);
        return false;
    }
    return path.edges_ < depth_ || first;
}

// Scatters the path at the surface that it has hit; false when it ends there.
bool Integrator::scatter(Path& path, const Painted& painted, float share, RayCount& count) const {
    const Hit& hit = path.hit_;
    const bool emerging = path.walking_;
    path.walking_ = false;
    const Surface surface =
        emerging ? materials_.emerging(hit, path.ray_.direction, painted)
                 : materials_.surface(hit, path.ray_.direction, painted, path.diffused_);
    if (path.edges_ == 1 && !emerging) {
        path.sample_.albedo = surface.bsdf.color;
        path.sample_.normal = surface.frame.z;
    }
    if (path.edges_ >= depth_)
        return false;
    const std::uint32_t bounce = bounce_of(path.edges_) + (emerging ? dimension::emerging : 0);
    const Vec2f choice = path.sampler_.pair(dimension::at(bounce, dimension::choice));
    if (mis_ != Mis::bsdf_only && !lights_.empty() && !surface.bsdf.delta())
        add_direct(path, hit, surface, bounce, choice.x, count);
    const BsdfSample scattered =
        surface.sample(choice.y, path.sampler_.pair(dimension::at(bounce, dimension::direction)));
    if (!(scattered.pdf > 0))
        return false;
    path.throughput_ *= scattered.weight;
    if (path.edges_ >= first_roulette_edge) {
        const float survival = std::min(1.0F, largest(path.throughput_) / kept_throughput);
        if (path.sampler_.pair(dimension::at(bounce, dimension::roulette)).x >= survival)
            return false;
        path.throughput_ /= survival;
    } else if (black(path.throughput_)) {
        return false;
    }
    if (scattered.transmitted && surface.material->subsurface() != nullptr) {
        path.color_ = painted.color;
        path.ray_.direction = scattered.direction;
        path.walking_ = true;
        return true;
    }
    if (scattered.transmitted && !surface.bsdf.lobe->traits().goes_through) {
        path.absorption_ =
            surface.outside ? surface.material->absorption() : Color(0.0F, 0.0F, 0.0F);
        path.absorbing_ = !black(path.absorption_);
    }
    // A direction of density p stands for a solid angle of 1 / p, and each of the N samples of the
    // pixel for 1 / N of that: textures seen by way of a wide lobe are filtered as widely.
    if (!scattered.delta)
        path.spread_ =
            std::max(path.spread_, std::min(widest_spread, share / std::sqrt(scattered.pdf)));
    path.diffused_ = path.diffused_ || (!scattered.delta && scattered.pdf < diffuse_density);
    path.pdf_ = scattered.pdf;
    path.delta_ = scattered.delta;
    path.point_ = hit.position;
    path.ray_ = hit.leave(scattered.direction);
    ++path.edges_;
    return true;
}

// Scatters all paths at the ends of their rays; whether any goes on.
bool Integrator::shade(std::span<Path> paths, float share, RayCount& count) const {
    bool any = false;
    std::array<Path*, most_painted> met;
    std::array<PaintQuery, most_painted> queries;
    std::array<Painted, most_painted> painted;
    std::size_t met_count = 0;
    const auto scatter_all = [&] {
        paint({queries.data(), met_count}, {painted.data(), met_count});
        for (std::size_t i = 0; i < met_count; ++i) {
            met[i]->alive_ = scatter(*met[i], painted[i], share, count);
            any = any || met[i]->alive_;
        }
        met_count = 0;
    };
    for (Path& path : paths) {
        path.alive_ = path.alive_ && arrive(path);
        if (!path.alive_)
            continue;
        met[met_count] = &path;
        queries[met_count++] = {&materials_.at(path.hit_).paint(), &path.hit_, path.ray_.direction,
                                path.width_};
        if (met_count == most_painted)
            scatter_all();
    }
    scatter_all();
    return any;
}

void Integrator::trace(std::span<Path> paths, float share, RayCount& count) const {
    for (bool any = true; any;) {
        for (Path& path : paths) {
            if (!path.alive_)
                continue;
            if (path.walking_) {
                walk(path, count);
                continue;
            }
            ++count.rays;
            path.found_ = world_.find(path.ray_, count.clock);
        }
        for (const Path& path : paths)
            if (path.alive_)
                world_.prefetch(path.found_);
        any = shade(paths, share, count);
    }
}

} // namespace scree
