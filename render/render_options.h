// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/integrator.h"

#include <cstdint>
#include <optional>

namespace scree {

/// A rectangle of the full picture [pixels].
struct Crop {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// One of `count` parts of a picture that are rendered apart, often on several machines.
struct Shard {
    int index = 0; // of [0, count)
    int count = 1;
};

/// How it is to be rendered.
struct RenderOptions {
    int samples = 0;          // per pixel; 0: as the film says
    double time_limit = 0;    // [s]; 0: none; at least one sample per pixel is taken
    double noise = 0;         // stop tiles below this ErrorEstimate; 0: never
    std::uint64_t seed = 0;   // same seed, same picture, on any number of threads
    std::optional<Crop> crop; // its pixels are those of the full picture
    Shard shard;              // pixels of the others stay without samples
    bool mattes = false;      // keep which instances and materials are seen
    int threads = 0;          // 0: as many as allowed
    Mis mis = Mis::both;
};

struct RenderStats {
    std::uint64_t rays = 0;
    double seconds = 0;      // wall clock
    double cpu_seconds = 0;  // of the whole process
    double embree_share = 0; // of the render threads' time, measured in every 13th batch of paths
    std::uint64_t invalid_samples = 0; // not finite or negative; dropped
    std::uint64_t samples = 0;         // of all pixels, also of the runs that this one resumed
    double samples_per_pixel = 0;      // mean over the pixels of the shard
    double error = 0; // estimate of the picture's relative error; see ErrorEstimate

    double mrays_per_s() const {
        return seconds > 0 ? static_cast<double>(rays) / seconds * 1e-6 : 0;
    }
};

} // namespace scree
