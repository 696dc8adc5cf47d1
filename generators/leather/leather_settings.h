// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree {

/// The numbers of a kind of leather. Lengths in metres, angles in radians.
struct LeatherSettings {
    std::string name;

    // The cells: irregular rounded polygons, placed without overlap.
    double cell = 0;              // mean width of a cell
    Range cell_range{1, 1};       // of their sizes, as factors of `cell`
    double gap_cell = 0;          // smallest cells that fill gaps, as a factor of `cell`; 0: none
    double elongation = 1;        // length by width
    double direction_spread = pi; // the long axis is within this of `direction`
    double irregularity = 0.5;    // of the outlines, 0 (nearly regular) to 1
    double meander = 0;           // how far the grooves wander off, as a share of `cell`

    // The cristae.
    double depth = 0;            // of the relief: height of a crista's top above the base
    double roundness = 0.5;      // 0: flat-topped, 1: domed as far as the middle
    double fullness = 0.5;       // 0: a parabola's soft flanks, 1: a circle's steep ones
    double height_variation = 0; // from cell to cell, as a share
    double tilt = 0;             // of the tops along the cell's long axis, as a share of the depth
    double overhang = 0;         // of the shoulders over the groove, as a share of its width

    // The sulci.
    double groove_width = 0;
    double groove_depth = 0;     // below the base
    double groove_variation = 0; // 0: all alike, 1: some fade out altogether

    // Minor grooves that subdivide the cells.
    double minor_cell = 0;  // their spacing as a share of `cell`; 0: none
    double minor_depth = 0; // depth

    // Fine detail.
    double wrinkle_depth = 0;
    double wrinkle_spacing = 1;
    double pore_depth = 0;
    double pore_width = 1;
    double pore_density = 0;     // pores per square of `cell` side
    double roughness = 0;        // height of the finest grain
    double undulation = 0;       // height of the waves that are longer than cells
    double undulation_cells = 6; // their length in cells
};

/// Which parts of the relief are made.
enum class ReliefParts { both, cristae, sulci };

/// The presets, by name: "fine_calf", "coarse_grain", "reptile", "pebbled".
const std::vector<LeatherSettings>& leather_presets();

/// Declarations of the parameters that `settings_from` reads: `preset` and one optional parameter
/// per number, which overrides the preset's.
std::vector<ParamSpec> leather_setting_specs();

/// The preset that `params` names with what it overrides. Throws Error, located, where numbers
/// that are each allowed do not go together.
LeatherSettings settings_from(const Params& params);

} // namespace scree
