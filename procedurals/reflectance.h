// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree {

/// A colour parameter that is a reflectance. Throws a located Error unless each channel is in [0,
/// 1].
inline Color reflectance(const Params& params, const std::string& name) {
    const Color& color = params.color(name);
    for (int i = 0; i < 3; ++i)
        if (!(color[i] >= 0 && color[i] <= 1))
            throw params.error(name, "a reflectance must be from 0 to 1");
    return color;
}

} // namespace scree
