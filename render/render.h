// SPDX-License-Identifier: GPL-3.0-or-later
// From a world and a camera to a film.
#pragma once

#include "core/context.h"
#include "model/film_settings.h"
#include "render/camera.h"
#include "render/film/film.h"
#include "render/integrator.h"
#include "render/world/world.h"

#include <functional>
#include <optional>

namespace scree {

/// A rectangle of the full picture [pixels].
struct Crop {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// How it is to be rendered.
struct RenderOptions {
    int samples = 0;          // per pixel; 0: as the film says
    double time_limit = 0;    // [s]; 0: none; at least one sample per pixel is taken
    double noise = 0;         // stop tiles below this Film::relative_error; 0: never
    std::uint64_t seed = 0;   // same seed, same picture, on any number of threads
    std::optional<Crop> crop; // its pixels are those of the full picture
    int threads = 0;          // 0: as many as allowed
    Mis mis = Mis::both;
    /// Called after every pass, for previews; `samples`: that every pixel has, but for those that
    /// are finished with fewer.
    std::function<void(const Film& film, int samples)> on_pass;
};

struct RenderStats {
    std::uint64_t rays = 0;
    double seconds = 0;      // wall clock
    double cpu_seconds = 0;  // of the whole process
    double embree_share = 0; // of the render threads' time, measured in every 13th batch of paths
    std::uint64_t invalid_samples = 0; // not finite or negative; dropped
    double samples_per_pixel = 0;      // mean reached

    double mrays_per_s() const {
        return seconds > 0 ? static_cast<double>(rays) / seconds * 1e-6 : 0;
    }
};

struct RenderResult {
    Film film;
    RenderStats stats;
    bool cancelled = false; // on the context's cancel: the film holds what was done until then
};

/// Renders in passes of growing length over the whole picture. Reports to the context's progress;
/// on cancel returns what there is. Throws Error (usage) on a crop outside of the picture.
RenderResult render(const World& world, const Camera& camera, const FilmSettings& settings,
                    const RenderOptions& options, const Context& context = {});

} // namespace scree
