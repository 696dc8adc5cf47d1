// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <string>
#include <vector>

namespace scree {

/// A timber, with real dimensions in metres.
struct WoodPreset {
    std::string name;
    Color early, late;
    double ring = 3e-3;                           // mean width of a ring
    bool sine = false;                            // the paper's profile
    double early_share = 0.45, late_share = 0.15; // of a year; the rest is the transition
    double late_sharpness = 0.85;                 // 1: the year ends abruptly
    double ring_variation = 0.35, tint_variation = 0.35;
    double turbulence = 1.6; // k, in cells of the paper's lattice of 64
    double stretch = 7;      // of the displacing field along the trunk
    double asymmetry = 0.12, wander = 2e-3;
    double fibre = 0.25;
    double pores = 0, pore_size = 0.18e-3, pore_length = 6e-3, ring_porous = 0;
    Color pore{0.05F, 0.03F, 0.02F};
    double rays = 0, ray_height = 2e-3, ray_width = 0.08e-3;
    Color ray{0.6F, 0.45F, 0.3F};
};

const std::vector<WoodPreset>& wood_presets();

} // namespace scree
