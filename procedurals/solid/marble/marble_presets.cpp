// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/marble/marble_presets.h"

#include "procedurals/solid/shown_color.h"

namespace scree {

const std::vector<MarblePreset>& marble_presets() {
    // Colours estimated from photographs of slabs.
    static const std::vector<MarblePreset> presets = {
        {"banded", // that of the paper: even layers
         shown(0xe6e1d6),
         shown(0xe6e1d6),
         0,
         {{shown(0x4a4744), 6, 0.03, 0.03, 0.9, 16, 0}}},
        {"carrara",
         shown(0xe9e8e4),
         shown(0xc3c6ca),
         0.55,
         {{shown(0x777c84), 3, 0.006, 0.030, 0.75, 26, 0.3},
          {shown(0x8b9096), 4, 0.002, 0.012, 0.5, 34, -0.7}}},
        {"calacatta",
         shown(0xf1ede3),
         shown(0xe2dac9),
         0.5,
         {{shown(0x7d766b), 2, 0.022, 0.035, 0.85, 30, 0.4},
          {shown(0xa98f5e), 3, 0.005, 0.020, 0.6, 34, 0.5},
          {shown(0x9c9a95), 4, 0.002, 0.010, 0.5, 30, -0.8}}},
        {"nero_marquina",
         shown(0x17171a),
         shown(0x26262a),
         0.6,
         {{shown(0xe9e6df), 2, 0.010, 0.003, 0.95, 34, 0.5},
          {shown(0xd8d5cf), 4, 0.0022, 0.0015, 0.8, 40, -0.6},
          {shown(0x8a8886), 5, 0.0010, 0.0020, 0.6, 30, 1.2}}},
        {"verde_alpi",
         shown(0x1f3a2c),
         shown(0x12241c),
         0.8,
         {{shown(0x6f9a7c), 5, 0.012, 0.020, 0.75, 36, 0.4},
          {shown(0xcfe0d2), 4, 0.003, 0.004, 0.8, 44, -0.5},
          {shown(0x0b1611), 4, 0.010, 0.020, 0.8, 30, 1.0}}},
        {"rosso_levanto",
         shown(0x5e2320),
         shown(0x3a1a1c),
         0.9,
         {{shown(0xd9cfc6), 3, 0.008, 0.006, 0.85, 40, 0.5},
          {shown(0x2d2a2a), 4, 0.012, 0.030, 0.8, 34, -0.4},
          {shown(0xb4a59c), 4, 0.0025, 0.003, 0.7, 38, 1.1}}},
        {"giallo_siena",
         shown(0xd9a548),
         shown(0xe9cf94),
         0.85,
         {{shown(0x7a3f22), 3, 0.006, 0.020, 0.75, 36, 0.3},
          {shown(0x54301f), 4, 0.002, 0.006, 0.7, 40, -0.8},
          {shown(0xf3e6c8), 3, 0.012, 0.030, 0.6, 30, 1.0}}},
        {"emperador",
         shown(0x4a3023),
         shown(0x6a4a36),
         0.8,
         {{shown(0xd8c3a5), 3, 0.004, 0.004, 0.8, 42, 0.6},
          {shown(0x2a1911), 4, 0.012, 0.030, 0.7, 30, -0.3},
          {shown(0xa98a6a), 5, 0.0018, 0.003, 0.7, 38, -1.0}}},
        {"honey_onyx",
         shown(0xe2b06a),
         shown(0xf2d7a6),
         0.7,
         {{shown(0x8f4a1c), 5, 0.012, 0.030, 0.75, 9, 0},
          {shown(0xfbf0d8), 5, 0.014, 0.025, 0.8, 9, 0},
          {shown(0x5b2a12), 4, 0.003, 0.006, 0.7, 10, 0}}},
    };
    return presets;
}

} // namespace scree
