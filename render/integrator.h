// SPDX-License-Identifier: GPL-3.0-or-later
// Unidirectional path tracing with next-event estimation (Kajiya 1986) and multiple importance
// sampling (Veach & Guibas 1995).
#pragma once

#include "model/film_settings.h"
#include "render/camera.h"
#include "render/film/path_sample.h"
#include "render/light/light_sampler.h"
#include "render/paint.h"
#include "render/sampler.h"
#include "render/surface.h"
#include "render/world/world.h"

namespace scree {

/// How direct light is sampled; all have the same mean. `both` has the least noise, the others are
/// for tests.
enum class Mis { both, light_only, bsdf_only };

/// Work done, for the statistics.
struct RayCount {
    std::uint64_t rays = 0;
    std::uint64_t* clock = nullptr; // receives the time inside Embree when given
};

/// A path under way.
class Path {
  public:
    /// `spread`: how much the filter that the path stands for widens per metre. `groups`, unless
    /// null, gets the radiance of each group of lights added; it must outlive this.
    Path(const CameraRay& ray, float spread, const Sampler& sampler, Color* groups = nullptr)
        : ray_{ray.origin, ray.direction}, point_(ray.origin), spread_(spread), sampler_(sampler),
          groups_(groups) {}

    /// Complete once the path has been traced.
    const PathSample& sample() const { return sample_; }

  private:
    friend class Integrator;

    PathSample sample_;
    Ray ray_;
    RawHit found_; // at the end of ray_
    Hit hit_;      // the same, where it is a surface
    Color throughput_{1.0F, 1.0F, 1.0F};
    Color absorption_{0.0F, 0.0F, 0.0F}; // of the glass that the ray is in, if any [1/m]
    Color color_;                        // of the translucent surface that it entered
    Vec3 point_;                         // where the ray was scattered
    float pdf_ = 0;                      // of its direction
    float width_ = 0;                    // of the filter where the ray begins [m]
    float spread_;                       // how much the filter widens per metre
    bool delta_ = true;                  // its direction cannot be found by light sampling
    bool absorbing_ = false;
    bool diffused_ = false; // has been scattered into a wide lobe
    bool walking_ = false;  // has entered a translucent surface and not come out yet
    bool alive_ = true;
    int edges_ = 1; // of the path up to the ray's end
    Sampler sampler_;
    Color* groups_;
};

/// Follows paths through a world. Thread-safe.
class Integrator {
  public:
    /// `world` must outlive this. Of the settings it takes depth, clamp and regularise.
    Integrator(const World& world, const FilmSettings& settings, Mis mis);

    /// Follows the paths to their ends, one edge of all paths at a time: memory is fetched for one
    /// while the rays of the others are traced, and a texture is evaluated for all of them at once.
    /// The results are the same as for each path alone.
    /// `share`: the width that one sample covers of its pixel's filter, and of a lobe in which its
    /// path is scattered, as a share of the whole width.
    void trace(std::span<Path> paths, float share, RayCount& count) const;

  private:
    void walk(Path& path, RayCount& count) const;
    bool arrive(Path& path) const;
    bool scatter(Path& path, const Painted& painted, float share, RayCount& count) const;
    bool shade(std::span<Path> paths, float share, RayCount& count) const;
    void add_escaped(Path& path) const;
    void add_light(Path& path, const Hit& hit) const;
    void add_direct(Path& path, const Hit& hit, const Surface& surface, std::uint32_t bounce,
                    float choice, RayCount& count) const;
    void add(Path& path, const Color& contribution, int edges, std::uint32_t light) const;
    float hit_weight(const Path& path, float light_pdf) const;

    const World& world_;
    MaterialSet materials_;
    LightSampler lights_;
    std::vector<std::uint32_t> group_of_; // by light
    int depth_;
    float clamp_;
    Mis mis_;
};

} // namespace scree
