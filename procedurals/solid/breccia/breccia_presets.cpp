// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/breccia/breccia_presets.h"

#include "procedurals/solid/shown_color.h"

namespace scree {

namespace {

Mineral fragment(unsigned rgb, double share, double millimetres, double variation = 0.08) {
    return {shown(rgb), share, millimetres * 1e-3, variation, 0.10, 0.06, 1};
}

BrecciaPreset breccia(const char* name, unsigned cement, std::vector<Mineral> stones,
                      std::vector<double> gaps) {
    BrecciaPreset preset;
    preset.name = name;
    preset.cement = preset.band = shown(cement);
    preset.stones.minerals = std::move(stones);
    for (const double gap : gaps)
        preset.stones.outlines.push_back({gap});
    preset.stones.clusters = 0.3;
    preset.stones.whole = false;
    preset.stones.gap_by_field = 0.55;
    preset.stones.roughness = 0.1;
    return preset;
}

BrecciaPreset oniciata() { // onyx in bands around the fragments
    BrecciaPreset preset = breccia("breccia_oniciata", 0x9a5c3c,
                                   {fragment(0xe2c9ae, 0.40, 40), fragment(0xcf9f80, 0.22, 40),
                                    fragment(0xb98263, 0.12, 40), fragment(0xe6d2ba, 0.26, 13),
                                    fragment(0xc48f70, 0.18, 13), fragment(0xdfc0a2, 0.25, 5)},
                                   {0.11, 0.10, 0.08});
    preset.band = shown(0xecd3b6);
    preset.bands = 0.85;
    preset.band_width = 3.4e-3;
    preset.veins = {{shown(0xf4ebde), 60e-3, 0.7e-3, 0.7}};
    preset.turbulence = 3.5;
    return preset;
}

BrecciaPreset grand_antique() {
    BrecciaPreset preset =
        breccia("grand_antique", 0xf1eee7,
                {fragment(0x141416, 0.56, 36, 0.3), fragment(0x232326, 0.16, 36, 0.3),
                 fragment(0x17171a, 0.34, 13, 0.3), fragment(0x2c2c30, 0.10, 13),
                 fragment(0x1b1b1e, 0.25, 5, 0.3)},
                {0.045, 0.07, 0.10});
    preset.veins = {{shown(0xe9e5dc), 45e-3, 0.8e-3, 0.9}, {shown(0xd8d4cc), 15e-3, 0.2e-3, 0.5}};
    preset.turbulence = 1.2;
    return preset;
}

BrecciaPreset medicea() {
    BrecciaPreset preset = breccia("breccia_medicea", 0x5c3140,
                                   {fragment(0xf0e8da, 0.46, 36), fragment(0xe3d3c0, 0.22, 36),
                                    fragment(0xcdb3a2, 0.12, 36), fragment(0xeadfce, 0.34, 11),
                                    fragment(0xb58e8a, 0.18, 11), fragment(0xe0cfc0, 0.3, 4)},
                                   {0.06, 0.08, 0.09});
    preset.band = shown(0x7d4a55);
    preset.bands = 0.5;
    preset.band_width = 4e-3;
    preset.veins = {{shown(0x6b3a48), 26e-3, 0.35e-3, 0.7}};
    preset.turbulence = 3.5;
    return preset;
}

BrecciaPreset pernice() {
    BrecciaPreset preset = breccia("breccia_pernice", 0x8a3a2f,
                                   {fragment(0xc58a78, 0.36, 30), fragment(0xdcb3a0, 0.26, 30),
                                    fragment(0xa85c4c, 0.2, 30), fragment(0xd9a895, 0.34, 10),
                                    fragment(0xb06b5b, 0.3, 10), fragment(0xcf9a88, 0.4, 4)},
                                   {0.05, 0.06, 0.07});
    preset.veins = {{shown(0xeadfd4), 55e-3, 1.0e-3, 0.8}, {shown(0x5e231d), 12e-3, 0.2e-3, 0.6}};
    preset.turbulence = 4;
    return preset;
}

BrecciaPreset aurora() {
    BrecciaPreset preset = breccia("breccia_aurora", 0xb1834f,
                                   {fragment(0xf0e4cc, 0.4, 46), fragment(0xe0c9a2, 0.25, 46),
                                    fragment(0xcfae80, 0.1, 46), fragment(0xece0c8, 0.35, 15),
                                    fragment(0xd3b486, 0.25, 15), fragment(0xdfcba6, 0.4, 5)},
                                   {0.045, 0.06, 0.08});
    preset.band = shown(0xd9b47c);
    preset.bands = 0.6;
    preset.band_width = 5e-3;
    preset.veins = {{shown(0x8a5a30), 34e-3, 0.35e-3, 0.7}, {shown(0xf6efe0), 70e-3, 0.8e-3, 0.7}};
    preset.turbulence = 3;
    return preset;
}

} // namespace

const std::vector<BrecciaPreset>& breccia_presets() {
    // Colours estimated from photographs of polished slabs.
    static const std::vector<BrecciaPreset> presets = {oniciata(), grand_antique(), medicea(),
                                                       pernice(), aurora()};
    return presets;
}

} // namespace scree
