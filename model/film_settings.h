// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace scree {

/// Reconstruction filters. All are sampled by importance, so that a pixel is the plain mean of its
/// own samples (Ernst, Stamminger & Greiner 2006) and pixels stay independent.
enum class Filter { box, triangle, gaussian, blackman_harris };

/// What the scene says about its picture; the command line may override parts of it.
struct FilmSettings {
    int width = 1280;
    int height = 720;
    int samples = 64; // per pixel
    int depth = 16;   // longest path in edges; 1 shows light sources only, 2 direct light
    Filter filter = Filter::blackman_harris;
    float radius = 1.5F; // of the filter [pixels]
    float clamp = 0;     // largest value of an indirect contribution; 0: unclamped, unbiased
    float exposure = 0;  // of the view [stops]
};

} // namespace scree
