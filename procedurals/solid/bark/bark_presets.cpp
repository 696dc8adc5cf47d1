// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/bark/bark_presets.h"

#include "procedurals/solid/shown_color.h"

namespace scree {

namespace {

BarkPreset bark(const char* name, unsigned dark, unsigned light, unsigned fissure) {
    BarkPreset preset;
    preset.name = name;
    preset.color[0] = shown(dark);
    preset.color[1] = shown(light);
    preset.fissure = shown(fissure);
    preset.bands.share = 0;
    return preset;
}

BarkPreset oak() { // long ridges that split and join
    BarkPreset preset = bark("oak", 0x75695a, 0xa3988a, 0x241c16);
    preset.fissures = {{21e-3, 5.5e-3, 0.05, 0.92, 4.5},
                       {8e-3, 1.2e-3, 0.05, 0.45, 3},
                       {6e-3, 0.4e-3, 0.02, 0.35, 0.8}};
    preset.flakes = {12e-3, 0.8e-3, 0.06, 0, 2.5};
    preset.lichen = shown(0x98a27f);
    preset.lichen_share = 0.35;
    preset.fibre = 0.10;
    preset.relief = 0.5e-3;
    preset.relief_size = 12e-3;
    preset.relief_stretch = 4;
    preset.turbulence = 4;
    return preset;
}

BarkPreset pine() { // plates of many flakes
    BarkPreset preset = bark("pine", 0x7d452c, 0xc4956f, 0x241610);
    preset.fissures = {{46e-3, 8e-3, 0.04, 0.96, 2.0}, {17e-3, 1.0e-3, 0.02, 0.6, 1.5}};
    preset.flakes = {13e-3, 2.2e-3, 0.025, 0, 1.3};
    preset.flake_edge = 0.45;
    preset.fibre = 0.08;
    preset.relief = 0.3e-3;
    preset.relief_size = 8e-3;
    preset.turbulence = 4;
    return preset;
}

BarkPreset birch() { // white, with pores across and black scars
    BarkPreset preset = bark("birch", 0xd9d3c7, 0xf0ece4, 0x6b5f54);
    preset.flakes = {40e-3, 0.1e-3, 0.10, 0, 0.35};
    preset.fissures = {{30e-3, 0.08e-3, 0.008, 0.35, 0.22}};
    preset.bands = {shown(0xc9b8a4), 6e-3, 0.4, 0.4, 0.2};
    preset.pores = {24e-3, 0.45, 0.10, 0.36, 0.13, 0.015};
    preset.pore = shown(0x4a3d34);
    preset.pore_height = 0.3e-3;
    preset.scars = {48e-3, 0.3, 0.06, 0.36, 0.4, 0.02};
    preset.scar = shown(0x1f1b18);
    preset.scar_height = 0.7e-3;
    preset.turbulence = 3.5;
    preset.roughness = 0.6;
    return preset;
}

BarkPreset plane() { // patches left by fallen flakes
    BarkPreset preset = bark("plane", 0x6f6b52, 0xdad2b0, 0x4d4634);
    preset.flakes = {42e-3, 1.0e-3, 0.012, 0, 1.5};
    preset.flake_edge = 0.2;
    preset.fissures = {{11e-3, 0.15e-3, 0.01, 0.15, 1.3}};
    preset.pores = {6e-3, 0.3, 0.05, 0.14, 0.8, 0.02};
    preset.pore = shown(0x5c543e);
    preset.pore_height = 0.15e-3;
    preset.lichen = shown(0x84906a);
    preset.lichen_share = 0.45;
    preset.turbulence = 6;
    preset.roughness = 0.6;
    return preset;
}

BarkPreset cherry() { // satin, with pores in rows
    BarkPreset preset = bark("cherry", 0x4f271f, 0x7c4433, 0x1f0f0b);
    preset.flakes = {30e-3, 0.3e-3, 0.09, 0, 0.4};
    preset.fissures = {{40e-3, 0.12e-3, 0.006, 0.25, 0.3}};
    preset.bands = {shown(0x9c6650), 11e-3, 0.45, 0.45, 0.15, 0.1e-3};
    preset.pores = {17e-3, 0.5, 0.12, 0.40, 0.16, 0.03};
    preset.pore = shown(0xb48a66);
    preset.pore_height = 0.7e-3;
    preset.turbulence = 1.6;
    preset.roughness = 0.32;
    return preset;
}

} // namespace

const std::vector<BarkPreset>& bark_presets() {
    // Colours and sizes estimated from photographs of trunks.
    static const std::vector<BarkPreset> presets = {oak(), pine(), birch(), plane(), cherry()};
    return presets;
}

} // namespace scree
