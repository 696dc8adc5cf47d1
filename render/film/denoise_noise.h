// SPDX-License-Identifier: GPL-3.0-or-later
// How noisy the pixels are that denoise() smooths, and those that are too bright by far.
#pragma once

#include "render/film/planes.h"

namespace scree {

/// What is known of the variance of a pixel's mean, in the mean over channels.
enum NoisePlane : int {
    noise_of_halves,  // unbiased, but noisy itself
    noise_of_samples, // as if samples were independent: steady, but too high by stratification
    noise_planes
};
/// In both planes, of a pixel with too few samples to tell.
inline constexpr float noise_unknown = -1;

/// The variance of a layer becomes its mean over 3 x 3 pixels.
void pool_variance(Planes& layer);

/// Sets the variance of the layer of light from that of the samples, scaled as the halves say
/// around (Rousselle, Knaus & Zwicker 2012, section 4); where it is unknown, by what light varies
/// among the pixels around. Then dims pixels that are too bright.
void find_noise(Planes& light, Planes& noise);

} // namespace scree
