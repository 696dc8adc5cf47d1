// SPDX-License-Identifier: GPL-3.0-or-later
// What presets say of creases, spots and beds, and these as the .cl texts take them.
#pragma once

#include "procedurals/solid/cells/beds_as_cpp.h"
#include "procedurals/solid/cells/cells_specs.h"
#include "procedurals/solid/cells/creases_as_cpp.h"
#include "procedurals/solid/cells/spots_as_cpp.h"

namespace scree {

/// Furrows between cells.
struct CreaseRecipe {
    double size = 1e-3; // of a cell [m]
    double depth = 0;   // of a furrow between two [m]
    double softness = 0.08;
    double dye = 0; // share of the crease's colour in one
    double stretch = 1;
    double jitter = 1;
};

/// Balls about seeds, flattened or drawn out with their cells.
struct SpotRecipe {
    double size = 1e-3;  // of a cell [m]
    double share = 0;    // of cells that have one
    double smallest = 0; // radii, in cells
    double largest = 0.2;
    double stretch = 1;
    double edge = 0.03; // deviation of its edge, in cells
    double jitter = 1;
};

/// Beds one over another.
struct BedRecipe {
    Color color{0.0F, 0.0F, 0.0F};
    double thickness = 0.01; // mean [m]
    double share = 0.5;      // of beds that have the colour
    double contrast = 0.5;   // share of the colour in a full one
    double softness = 0.1;   // deviation with which one goes over into the next, in beds
    double height = 0;       // a full bed stands out so far [m]
};

/// `scale` is a factor of all lengths; `use` tells the shapes of a texture apart.
solid::Creases make_creases(const Params& params, unsigned use, const CreaseRecipe& recipe,
                            double scale);
solid::Spots make_spots(const Params& params, unsigned use, const SpotRecipe& recipe, double scale);
solid::Beds make_beds(const Params& params, unsigned use, const BedRecipe& recipe, double scale);

/// The text of creases, spots and beds for devices, followed by these.
std::string shapes_program(const std::vector<const char*>& texts);

} // namespace scree
