// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/leather/leather_presets.h"

#include "procedurals/solid/shown_color.h"

namespace scree {

namespace {

LeatherPreset leather(const char* name, unsigned color, unsigned crease,
                      std::vector<CreaseRecipe> creases) {
    LeatherPreset preset;
    preset.name = name;
    preset.color = shown(color);
    preset.crease = preset.pore = shown(crease);
    preset.creases = std::move(creases);
    return preset;
}

LeatherPreset shagreen() { // of ray: adjacent pearls, ground flat, with dye between them
    LeatherPreset preset =
        leather("shagreen", 0xc3cdb9, 0x1f4a40, {{2.3e-3, 0.16e-3, 0.06, 1.2, 1, 0.6}});
    preset.stain = 0.04;
    preset.roughness = 0.22;
    preset.turbulence = 0.5;
    return preset;
}

LeatherPreset pigskin() {
    LeatherPreset preset = leather("pigskin", 0xb98a58, 0x6b4526,
                                   {{1.7e-3, 0.07e-3, 0.09, 0.4}, {0.6e-3, 0.02e-3, 0.08, 0.2}});
    preset.pores = {1.9e-3, 0.55, 0.10, 0.17, 1, 0.04};
    preset.pore_depth = 0.25e-3;
    preset.pore = shown(0x402613);
    preset.pore_dye = 0.8;
    preset.roughness = 0.45;
    return preset;
}

LeatherPreset ostrich() { // knobs at the quill follicles
    LeatherPreset preset = leather("ostrich", 0xa8662f, 0x5a3014,
                                   {{3.2e-3, 0.10e-3, 0.06, 0.45}, {1.0e-3, 0.03e-3, 0.08, 0.2}});
    preset.pores = {15e-3, 0.8, 0.10, 0.15, 1, 0.045, 0.8};
    preset.pore_depth = -1.1e-3;
    preset.pore = shown(0x6f3c18);
    preset.pore_dye = 0.55;
    return preset;
}

} // namespace

const std::vector<LeatherPreset>& solid_leather_presets() {
    // Sizes and depths of the grain estimated from photographs with a scale.
    static const std::vector<LeatherPreset> presets = [] {
        std::vector<LeatherPreset> made = {
            leather("calf", 0x8a4f2a, 0x43240f,
                    {{1.1e-3, 0.045e-3, 0.07, 0.55},
                     {0.45e-3, 0.015e-3, 0.08, 0.3},
                     {9e-3, 0.05e-3, 0.012, 0.3}}),
            leather("buffalo", 0x46291a, 0x160b06,
                    {{5.0e-3, 0.45e-3, 0.05, 0.7},
                     {1.7e-3, 0.12e-3, 0.08, 0.5},
                     {0.6e-3, 0.02e-3, 0.08, 0.2}}),
            leather("morocco", 0x8f1d1a, 0x3a0908,
                    {{1.9e-3, 0.22e-3, 0.10, 0.6, 1, 0.85}, {0.7e-3, 0.03e-3, 0.08, 0.3}}),
            shagreen(),
            pigskin(),
            ostrich(),
        };
        made[0].roughness = 0.34;
        made[1].roughness = 0.42;
        made[1].turbulence = 3;
        made[1].stain = 0.1;
        made[2].roughness = 0.32;
        return made;
    }();
    return presets;
}

} // namespace scree
