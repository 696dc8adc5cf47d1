// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/granite/granite_presets.h"

#include "procedurals/solid/shown_color.h"

namespace scree {

namespace {

Mineral mineral(unsigned rgb, double share, double millimetres, double variation = 0.1,
                double facet = 0.06, double gloss = 1) {
    return {shown(rgb), share, millimetres * 1e-3, variation, facet, 0.03, gloss};
}

GranitePreset granite(const char* name, std::vector<Mineral> minerals) {
    GranitePreset preset;
    preset.name = name;
    preset.grains.minerals = std::move(minerals);
    return preset;
}

GranitePreset baltic_brown() { // rapakivi: round feldspars with greenish rims
    GranitePreset preset = granite(
        "baltic_brown", {mineral(0x8a5a41, 0.48, 24, 0.22, 0.10), mineral(0x6e4636, 0.27, 24, 0.2),
                         mineral(0x7d5b47, 0.06, 7, 0.2), mineral(0x6f6a64, 0.07, 5, 0.2),
                         mineral(0x1f1b19, 0.07, 4, 0.3, 0.1, 1.5), mineral(0x4d4a3c, 0.05, 3)});
    preset.grains.outlines = {{0.025, 0.60, 0.075, 0.75, shown(0x4f4d40)}};
    preset.grains.jitter = 0.8;
    preset.turbulence = 2;
    return preset;
}

} // namespace

const std::vector<GranitePreset>& granite_presets() {
    // Colours estimated from photographs of polished slabs; shares and sizes of feldspars, quartz
    // and mica within the ranges of their rock types.
    static const std::vector<GranitePreset> presets = {
        granite("bianco_sardo",
                {mineral(0xd8d1c8, 0.30, 9, 0.10, 0.10), mineral(0xe6e2db, 0.24, 5.5, 0.06),
                 mineral(0x9b9a9b, 0.28, 5, 0.22, 0.12),
                 mineral(0x2a2a2c, 0.13, 2.6, 0.4, 0.1, 1.6), mineral(0x77736e, 0.05, 1.6, 0.3)}),
        granite("rosa_porrino",
                {mineral(0xc78f7d, 0.40, 13, 0.13, 0.10), mineral(0x9f9a97, 0.27, 7, 0.22, 0.12),
                 mineral(0xdccfc4, 0.18, 6, 0.08), mineral(0x2b2829, 0.15, 3, 0.4, 0.1, 1.6)}),
        baltic_brown(),
        granite("nero_africa",
                {mineral(0x1b1c1f, 0.50, 4, 0.35, 0.2), mineral(0x34373a, 0.32, 3, 0.3, 0.3),
                 mineral(0x585c60, 0.12, 2, 0.3, 0.3), mineral(0x0e0f10, 0.06, 1.5, 0.2)}),
        granite("blue_pearl", // larvikite, with iridescent blue feldspars
                {mineral(0x3c4854, 0.36, 13, 0.35, 0.5, 0.8),
                 mineral(0x7d93a8, 0.16, 11, 0.3, 0.6, 0.7), mineral(0x4b4a4a, 0.20, 8, 0.25, 0.3),
                 mineral(0x191b1f, 0.20, 5, 0.4, 0.1, 1.4), mineral(0x5a6570, 0.08, 2.5, 0.3)}),
        granite("imperial_red",
                {mineral(0x7e2d22, 0.45, 9, 0.2, 0.12), mineral(0x93422f, 0.15, 6, 0.15),
                 mineral(0x4b4042, 0.25, 5, 0.25, 0.1),
                 mineral(0x1b1718, 0.15, 2.6, 0.3, 0.1, 1.6)}),
    };
    return presets;
}

} // namespace scree
