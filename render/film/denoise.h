// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"
#include "render/film/film.h"

namespace scree {

/// The film's picture without most of its noise: R, G, B, A, finite, with the alpha of the beauty.
///
/// Radiance is divided by the first surface's albedo, so that textures are left out of what is
/// smoothed, and fitted around each pixel as a linear function of albedo and normal (Moon, Carr &
/// Yoon 2014, "Adaptive rendering based on weighted local regression") to the pixels that NL-means
/// finds alike: those whose surroundings differ no more than their noise explains (Rousselle, Knaus
/// & Zwicker 2012, "Adaptive rendering with non-local means filtering"), on surfaces that are alike
/// (Rousselle, Manzi & Zwicker 2013, "Robust denoising using feature and color information"). Noise
/// is what two halves of a pixel's samples differ by. With a single sample a pixel it is taken from
/// the pixels around. A pixel that few of its samples make far brighter than those around it is
/// dimmed to the brightest of these: some energy of what was hardly found is lost.
///
/// The same film gives the same bytes, on any number of threads.
Image denoise(const Film& film);

} // namespace scree
