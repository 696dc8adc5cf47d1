// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells/cells_specs.h"
#include "procedurals/solid/cells/grains_as_cpp.h"

namespace scree {

/// A mineral of a stone, or a kind of fragments.
struct Mineral {
    Color color{0.5F, 0.5F, 0.5F};
    double share = 1;        // of the stone's volume, relative to the others
    double size = 5e-3;      // of its grains [m]
    double variation = 0.08; // of brightness between grains
    double facet = 0.06;     // of brightness across a grain
    double mottle = 0.03;    // change of brightness per unit of the fractal field
    double gloss = 1;        // factor of the stone's roughness
};

/// The outline of grains of one size in their cells: see GrainLayer.
struct GrainOutline {
    double gap = -1; // in cells, as all lengths here; negative: grains fill their cells
    double radius = 9;
    double rim = 0;
    double rim_share = 0;
    Color rim_color{0.0F, 0.0F, 0.0F};
};

/// The composition of a stone.
struct GrainRecipe {
    std::vector<Mineral> minerals;
    std::vector<GrainOutline> outlines; // by size, largest first; other sizes fill their cells
    double clusters = 0.2;              // correlation of grains with the field
    double gap_by_field = 0;            // relative change of gaps per unit of the field
    double jitter = 1;                  // 0: grains on a grid, 1: random
    double roughness = 0.12;
    bool whole = true; // the smallest grains fill the rest; otherwise a cement does
};

/// Converts a recipe to the struct of grains.cl. The `value` of a kind increases with its lightness
/// from 0 to 1. Throws Error at `field` when there are too many kinds or sizes.
solid::Grains make_grains(const Params& params, const std::string& field, GrainRecipe recipe,
                          const solid::Lattice& lattice);

/// The declaration of a list of minerals, and the minerals of such a list.
ParamSpec minerals_spec(std::string name, std::string doc);
std::vector<Mineral> minerals_of(const std::vector<Params>& list, double otherwise_size);

} // namespace scree
