// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/medium.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

float single_scattering_albedo(float color) {
    // color = (1 - s) (1 - 0.139 s) / (1 + 1.17 s), s^2 = 1 - albedo.
    const float b = 1.139F + 1.17F * color;
    const float s = 2 * (1 - color) / (b + std::sqrt(b * b - 4 * 0.139F * (1 - color)));
    return std::max(0.0F, 1 - s * s);
}

} // namespace

Medium make_medium(const Color& color, const Color& distance) {
    Medium medium;
    medium.color = color;
    for (int c = 0; c < 3; ++c) {
        const float a = color[c];
        medium.albedo[c] = single_scattering_albedo(a);
        medium.mean_free_path[c] = distance[c] * (1.9F - a + 3.5F * (a - 0.8F) * (a - 0.8F));
    }
    return medium;
}

} // namespace scree
