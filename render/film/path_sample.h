// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <cstdint>

namespace scree {

/// What one path adds to its pixel.
struct PathSample {
    static constexpr std::uint32_t none = 0xffffffffU;

    Color radiance{0.0F, 0.0F, 0.0F};
    Color albedo{0.0F, 0.0F, 0.0F}; // of the first surface; 0 for the background
    Vec3 normal{0.0F, 0.0F, 0.0F};  // its shading normal
    Vec3 position{0.0F, 0.0F, 0.0F};
    float distance = 0; // along the ray [m]
    std::uint32_t instance = none;
    std::uint32_t material = 0; // of an instance
    bool covered = false;       // the ray met something
};

} // namespace scree
