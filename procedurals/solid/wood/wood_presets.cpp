// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/wood/wood_presets.h"

#include "procedurals/solid/shown_color.h"

namespace scree {

namespace {

WoodPreset timber(const char* name, unsigned early, unsigned late) {
    WoodPreset wood;
    wood.name = name;
    wood.early = shown(early);
    wood.late = shown(late);
    return wood;
}

WoodPreset paper() { // Okada et al. 1987: sine rings, displaced as marble
    WoodPreset wood = timber("paper", 0xd9a866, 0x7d4a22);
    wood.ring = 0.1 / 16;
    wood.sine = true;
    wood.ring_variation = wood.tint_variation = 0;
    wood.stretch = 1;
    wood.asymmetry = wood.wander = wood.fibre = 0;
    return wood;
}

WoodPreset pine() {
    WoodPreset wood = timber("pine", 0xe9c48d, 0xb9773a);
    wood.ring = 3.2e-3;
    wood.early_share = 0.5;
    wood.late_share = 0.10;
    wood.late_sharpness = 0.92;
    wood.fibre = 0.14;
    return wood;
}

WoodPreset oak() { // ring-porous, with broad rays
    WoodPreset wood = timber("oak", 0xc49a63, 0x93683a);
    wood.ring = 2.4e-3;
    wood.early_share = 0.3;
    wood.late_share = 0.25;
    wood.fibre = 0.3;
    wood.pores = 0.75;
    wood.pore_size = 0.26e-3;
    wood.pore_length = 9e-3;
    wood.ring_porous = 0.85;
    wood.pore = shown(0x4a2f18);
    wood.rays = 0.6;
    wood.ray_height = 14e-3;
    wood.ray_width = 0.3e-3;
    wood.ray = shown(0xd9b888);
    return wood;
}

WoodPreset ash() {
    WoodPreset wood = timber("ash", 0xdfc199, 0xb48d5e);
    wood.ring = 2.8e-3;
    wood.early_share = 0.25;
    wood.late_share = 0.3;
    wood.pores = 0.7;
    wood.pore_size = 0.24e-3;
    wood.ring_porous = 0.95;
    wood.pore = shown(0x7a5a38);
    wood.fibre = 0.22;
    return wood;
}

WoodPreset walnut() { // half-ring-porous
    WoodPreset wood = timber("walnut", 0x7d5638, 0x452a1a);
    wood.ring = 3.6e-3;
    wood.turbulence = 3.2;
    wood.late_sharpness = 0.6;
    wood.early_share = 0.2;
    wood.tint_variation = 0.6;
    wood.fibre = 0.45;
    wood.pores = 0.5;
    wood.pore_size = 0.2e-3;
    wood.pore_length = 7e-3;
    wood.ring_porous = 0.4;
    wood.pore = shown(0x24140c);
    return wood;
}

WoodPreset cherry() { // diffuse-porous, fine
    WoodPreset wood = timber("cherry", 0xb9734a, 0x8b4a2c);
    wood.ring = 2.6e-3;
    wood.late_sharpness = 0.7;
    wood.early_share = 0.35;
    wood.fibre = 0.25;
    wood.pores = 0.35;
    wood.pore_size = 0.07e-3;
    wood.pore_length = 2e-3;
    wood.pore = shown(0x5e2f1b);
    wood.rays = 0.6;
    wood.ray_height = 1.6e-3;
    wood.ray = shown(0xd09468);
    return wood;
}

WoodPreset beech() { // with rays visible as flecks
    WoodPreset wood = timber("beech", 0xd9ae84, 0xbb8a5f);
    wood.ring = 2.2e-3;
    wood.fibre = 0.12;
    wood.tint_variation = 0.5;
    wood.pores = 0.3;
    wood.pore_size = 0.07e-3;
    wood.pore_length = 2e-3;
    wood.pore = shown(0x9a6a44);
    wood.rays = 0.8;
    wood.ray_height = 2.5e-3;
    wood.ray_width = 0.14e-3;
    wood.ray = shown(0x9a6238);
    return wood;
}

WoodPreset maple() {
    WoodPreset wood = timber("maple", 0xe6cfaa, 0xcba678);
    wood.ring = 2.5e-3;
    wood.early_share = 0.6;
    wood.late_share = 0.06;
    wood.turbulence = 2.4;
    wood.fibre = 0.12;
    wood.rays = 0.5;
    wood.ray_height = 0.9e-3;
    wood.ray = shown(0xc29a6c);
    return wood;
}

WoodPreset teak() {
    WoodPreset wood = timber("teak", 0xb07f45, 0x6d4522);
    wood.ring = 3.4e-3;
    wood.turbulence = 2.2;
    wood.late_sharpness = 0.75;
    wood.fibre = 0.4;
    wood.pores = 0.55;
    wood.pore_size = 0.22e-3;
    wood.pore_length = 8e-3;
    wood.ring_porous = 0.7;
    wood.pore = shown(0x3a2412);
    return wood;
}

WoodPreset rosewood() {
    WoodPreset wood = timber("rosewood", 0x7a3a26, 0x2a120d);
    wood.ring = 2.6e-3;
    wood.turbulence = 4.5;
    wood.early_share = 0.15;
    wood.late_share = 0.3;
    wood.late_sharpness = 0.5;
    wood.tint_variation = 0.8;
    wood.fibre = 0.4;
    wood.pores = 0.3;
    wood.pore_size = 0.2e-3;
    wood.pore = shown(0x160806);
    return wood;
}

} // namespace

const std::vector<WoodPreset>& wood_presets() {
    // Rings, vessels and rays from Hoadley, "Identifying Wood" (1990); colours estimated by eye.
    static const std::vector<WoodPreset> presets = {oak(),   pine(),  ash(),  walnut(),   cherry(),
                                                    beech(), maple(), teak(), rosewood(), paper()};
    return presets;
}

} // namespace scree
