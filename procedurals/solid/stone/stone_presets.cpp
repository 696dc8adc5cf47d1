// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/stone/stone_presets.h"

#include "procedurals/solid/shown_color.h"

namespace scree {

namespace {

StonePreset stone(const char* name, unsigned color, std::vector<BedRecipe> beds) {
    StonePreset preset;
    preset.name = name;
    preset.color = shown(color);
    preset.beds = std::move(beds);
    preset.shells.whole = false;
    return preset;
}

Mineral shell(unsigned rgb, double share, double millimetres) {
    return {shown(rgb), share, millimetres * 1e-3, 0.05, 0.05, 0.02, 1};
}

StonePreset portland() {
    StonePreset preset = stone("portland", 0xd8cfba, {{shown(0xcbbf9f), 35e-3, 0.5, 0.35, 0.25}});
    preset.sand = 0.55e-3; // ooids
    preset.sandy = 0.07;
    preset.shells.minerals = {shell(0xe9e4d8, 0.10, 7), shell(0xb5a78b, 0.08, 7),
                              shell(0xe4decf, 0.14, 2.6), shell(0xa89a80, 0.10, 2.6)};
    preset.shells.outlines = {{0.20, 0.36, 0.05, 0.5, shown(0xa99b80)}, {0.16, 0.38}};
    preset.holes = {{9e-3, 0.3, 0.03, 0.16}, {3e-3, 0.2, 0.04, 0.2}};
    preset.hole_depth = 0.5e-3;
    preset.hole = shown(0x8d7f66);
    preset.relief = 0.2e-3;
    preset.relief_size = 20e-3;
    preset.roughness = 0.8;
    return preset;
}

StonePreset travertine_romano() {
    StonePreset preset = stone("travertine_romano", 0xdcc9a8,
                               {{shown(0xc6a678), 20e-3, 0.5, 0.6, 0.14},
                                {shown(0xefe5d0), 7e-3, 0.45, 0.5, 0.16},
                                {shown(0xb3905f), 2.2e-3, 0.35, 0.3, 0.2}});
    preset.sand = 0.9e-3;
    preset.sandy = 0.03;
    preset.holes = {{13e-3, 0.55, 0.06, 0.40, 0.33, 0.03}, {5e-3, 0.4, 0.05, 0.36, 0.45, 0.03}};
    preset.hole_beds = 0.85;
    preset.hole_depth = 2e-3;
    preset.hole = shown(0x6e5233);
    preset.turbulence = 5;
    preset.flatness = 0.7;
    preset.roughness = 0.45;
    return preset;
}

StonePreset red_sandstone() {
    StonePreset preset = stone("red_sandstone", 0xaa5a3d,
                               {{shown(0xc58260), 45e-3, 0.5, 0.35, 0.02},
                                {shown(0x7c3826), 4e-3, 0.5, 0.55, 0.14},
                                {shown(0xd6a17d), 1.4e-3, 0.4, 0.35, 0.2}});
    preset.cross = 0.7;
    preset.sand = 0.4e-3;
    preset.sandy = 0.16;
    preset.relief = 0.35e-3;
    preset.relief_size = 12e-3;
    preset.turbulence = 1.6;
    preset.roughness = 0.9;
    return preset;
}

StonePreset rainbow_sandstone() {
    StonePreset preset = stone("rainbow_sandstone", 0xe3cba6,
                               {{shown(0x9a4b38), 17e-3, 0.45, 0.85, 0.10},
                                {shown(0xcf9a5a), 8e-3, 0.5, 0.6, 0.14},
                                {shown(0x6d3a3c), 3e-3, 0.3, 0.5, 0.2}});
    preset.sand = 0.4e-3;
    preset.sandy = 0.10;
    preset.relief = 0.15e-3;
    preset.relief_size = 12e-3;
    preset.turbulence = 13;
    preset.roughness = 0.75;
    return preset;
}

StonePreset welsh_slate() {
    StonePreset preset = stone("welsh_slate", 0x454a54,
                               {{shown(0x50485a), 30e-3, 0.5, 0.5, 0.3},
                                {shown(0x343940), 2.4e-3, 0.5, 0.45, 0.12, 0.12e-3},
                                {shown(0x666d78), 0.8e-3, 0.45, 0.3, 0.12}});
    preset.sand = 0.35e-3;
    preset.sandy = 0.06;
    preset.relief = 0.5e-3;
    preset.relief_size = 50e-3;
    preset.relief_stretch = 0.3;
    preset.turbulence = 0.5;
    preset.roughness = 0.5;
    return preset;
}

StonePreset jura() {
    StonePreset preset =
        stone("jura", 0xd3be98,
              {{shown(0xc2a675), 40e-3, 0.5, 0.4, 0.3}, {shown(0xe0d2b4), 6e-3, 0.4, 0.3, 0.3}});
    preset.sand = 0.7e-3;
    preset.sandy = 0.03;
    preset.cloudy = 0.06;
    preset.shells.minerals = {shell(0xe6dcc4, 0.10, 16), shell(0xad8d5d, 0.06, 16),
                              shell(0xe9e1cd, 0.14, 6), shell(0x94764c, 0.10, 6),
                              shell(0xa88858, 0.16, 2.5)};
    preset.shells.outlines = {{0.10, 0.45, 0.06, 0.6, shown(0x8a6c44)},
                              {0.12, 0.42, 0.05, 0.4, shown(0x7d623c)},
                              {0.1, 0.4}};
    preset.shells.roughness = preset.roughness = 0.25;
    preset.turbulence = 3;
    return preset;
}

} // namespace

const std::vector<StonePreset>& stone_presets() {
    // Colours and sizes estimated from photographs of cut and weathered faces.
    static const std::vector<StonePreset> presets = {portland(),      travertine_romano(),
                                                     red_sandstone(), rainbow_sandstone(),
                                                     welsh_slate(),   jura()};
    return presets;
}

} // namespace scree
