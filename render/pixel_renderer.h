// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/film_settings.h"
#include "render/camera.h"
#include "render/film/film.h"
#include "render/film/filter.h"
#include "render/integrator.h"
#include "render/render_options.h"

#include <atomic>
#include <vector>

namespace scree {

/// Renders samples of pixels: what a sample is, whichever thread, pass or run renders it.
class PixelRenderer {
  public:
    /// `world` must outlive this.
    PixelRenderer(const World& world, const Camera& camera, const FilmSettings& settings,
                  const RenderOptions& options, const Crop& crop);

    /// Sets the width that one sample covers of its pixel's filter, as a share of the whole width:
    /// textures are filtered by it, and the mean of the samples filters them over the rest.
    void set_share(float share);

    class Batch;

    /// The radiance of one sample of a pixel of the film; not counted.
    Color radiance(int x, int y, int sample) const;

    std::uint64_t rays() const { return rays_; }
    std::uint64_t invalid() const { return invalid_; }
    double embree_share() const;

  private:
    Path path(int x, int y, int sample, Color* groups = nullptr) const;

    std::uint64_t seed_;
    Crop crop_;
    CameraRays camera_;
    FilterSampler filter_;
    Integrator integrator_;
    float share_ = 1;
    float spread_ = 0; // of one sample's filter, per metre of way
    std::atomic<std::uint64_t> rays_ = 0;
    std::atomic<std::uint64_t> invalid_ = 0;
    std::atomic<std::uint64_t> embree_ticks_ = 0;
    std::atomic<std::uint64_t> timed_ticks_ = 0;
};

/// The paths of a few samples, of one or more pixels, traced together. For one thread.
class PixelRenderer::Batch {
  public:
    /// `number` chooses the batches that are timed.
    Batch(PixelRenderer& renderer, Film& film, std::size_t number);
    /// Adds what was counted to the renderer's sums.
    ~Batch();
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;

    /// Adds a sample of a pixel of the film, which gets it at the latest with flush().
    void add(int x, int y, int sample);
    void flush();

  private:
    struct Pixel {
        int x, y;
    };

    void begin();

    PixelRenderer& renderer_;
    Film& film_;
    std::size_t number_;
    std::vector<Path> paths_;
    std::vector<Color> groups_; // by path and light group
    std::vector<Pixel> pixels_;
    RayCount count_;
    std::uint64_t start_ = 0;
    std::uint64_t embree_ = 0;
    std::uint64_t whole_ = 0;
    std::uint64_t invalid_ = 0;
};

} // namespace scree
