// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

namespace scree {

/// How strongly the colour of a bunch of fibres depends on their absorption, by their roughness
/// `beta_n` around the axis (Chiang et al. 2016, eq. 9).
inline float fibre_color_factor(float b) {
    return 5.969F + b * (-0.215F + b * (2.532F + b * (-10.73F + b * (5.574F + b * 0.245F))));
}

/// The absorption coefficient [1/radius] of fibres of which a thick bunch has this colour, each
/// part in [0, 1].
inline Color fibre_absorption(const Color& color, float beta_n) {
    const float factor = fibre_color_factor(beta_n);
    Color out;
    for (int i = 0; i < 3; ++i) {
        const float root = std::log(color[i]) / factor;
        out[i] = root * root;
    }
    return out;
}

/// The inverse of `fibre_absorption`; each part of `absorption` at least 0.
inline Color fibre_color(const Color& absorption, float beta_n) {
    Color out;
    for (int i = 0; i < 3; ++i)
        out[i] = std::exp(-std::sqrt(absorption[i]) * fibre_color_factor(beta_n));
    return out;
}

} // namespace scree
