// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells/cells_specs.h"
#include "procedurals/solid/cells/grains_as_cpp.h"

namespace scree {

/// One mineral of a stone, or one kind of its fragments.
struct Mineral {
    Color color{0.5F, 0.5F, 0.5F};
    double share = 1;        // of the stone's volume, against those of the others
    double size = 5e-3;      // of its grains [m]
    double variation = 0.08; // of brightness from grain to grain
    double facet = 0.06;     // of brightness across a grain
    double mottle = 0.03;    // of brightness by the fractal field
    double gloss = 1;        // factor of the stone's roughness
};

/// How grains of one size fill their cells: see GrainLayer.
struct GrainOutline {
    double gap = -1; // in cells, as all here; below 0: they fill them
    double radius = 9;
    double rim = 0;
    double rim_share = 0;
    Color rim_color{0.0F, 0.0F, 0.0F};
};

/// What a stone is put together of, largest grains first.
struct GrainRecipe {
    std::vector<Mineral> minerals;
    std::vector<GrainOutline> outlines; // of the sizes, largest first; the others fill their cells
    double clusters = 0.2;              // correlation of neighbours by the field
    double gap_by_field = 0;            // gaps' change per unit of the field, of themselves
    double jitter = 1;                  // 0: grains on a grid, 1: anywhere
    double roughness = 0.12;
    bool whole = true; // the smallest grains fill what is left; otherwise something else does
};

/// Cells of `recipe` as the .cl text takes them; `value` of a kind goes by its lightness from 0 to
/// 1. Throws Error at `field` when there are too many kinds or sizes.
solid::Grains make_grains(const Params& params, const std::string& field, GrainRecipe recipe,
                          const solid::Lattice& lattice);

/// Minerals as a list parameter, and what such a list says.
ParamSpec minerals_spec(std::string name, std::string doc);
std::vector<Mineral> minerals_of(const std::vector<Params>& list, double otherwise_size);

} // namespace scree
