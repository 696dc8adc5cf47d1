// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace scree {

/// Reconstruction filters. All are importance-sampled: a pixel is the unweighted mean of its
/// samples and does not depend on other pixels (Ernst, Stamminger & Greiner 2006).
enum class Filter { box, triangle, gaussian, blackman_harris };

/// The scene's settings of the picture; the command line may override some of them.
struct FilmSettings {
    int width = 1280;
    int height = 720;
    int samples = 64; // per pixel
    int depth = 16;   // maximum path length in edges; 1 shows light sources only, 2 direct light
    Filter filter = Filter::blackman_harris;
    float radius = 1.5F;  // of the filter [pixels]
    float clamp = 0;      // upper limit of an indirect contribution; 0: unclamped, unbiased
    float regularise = 0; // least roughness of what light meets after a diffuse bounce; 0: unbiased
    float exposure = 0;   // of the displayed picture [stops]
};

} // namespace scree
