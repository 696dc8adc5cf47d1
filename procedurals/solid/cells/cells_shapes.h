// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of creases, spots and beds in presets, and their conversion to the structs of the
// .cl files.
#pragma once

#include "procedurals/solid/cells/beds_as_cpp.h"
#include "procedurals/solid/cells/cells_specs.h"
#include "procedurals/solid/cells/creases_as_cpp.h"
#include "procedurals/solid/cells/spots_as_cpp.h"

namespace scree {

/// Furrows between cells.
struct CreaseRecipe {
    double size = 1e-3; // of a cell [m]
    double depth = 0;   // of a furrow between two cells [m]
    double softness = 0.08;
    double dye = 0; // share of the crease colour in a crease
    double stretch = 1;
    double jitter = 1;
};

/// Balls around seeds, flattened or elongated together with their cells.
struct SpotRecipe {
    double size = 1e-3;  // of a cell [m]
    double share = 0;    // of cells that have a spot
    double smallest = 0; // radii, in cells
    double largest = 0.2;
    double stretch = 1;
    double edge = 0.03; // standard deviation of the blur of its edge, in cells
    double jitter = 1;
};

/// A sequence of beds.
struct BedRecipe {
    Color color{0.0F, 0.0F, 0.0F};
    double thickness = 0.01; // mean [m]
    double share = 0.5;      // of beds that have the colour
    double contrast = 0.5;   // share of the colour in a full bed
    double softness = 0.1;   // standard deviation of the blur between adjacent beds, in beds
    double height = 0;       // of a full bed above the others [m]
};

/// `scale` multiplies all lengths; different `use`s make the shapes of a texture independent.
solid::Creases make_creases(const Params& params, unsigned use, const CreaseRecipe& recipe,
                            double scale);
solid::Spots make_spots(const Params& params, unsigned use, const SpotRecipe& recipe, double scale);
solid::Beds make_beds(const Params& params, unsigned use, const BedRecipe& recipe, double scale);

/// The OpenCL source of creases, spots and beds, followed by `texts`.
std::string shapes_program(const std::vector<const char*>& texts);

} // namespace scree
