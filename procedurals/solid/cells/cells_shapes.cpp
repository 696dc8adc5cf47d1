// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/cells/cells_shapes.h"

#include "core/random.h"
#include "procedurals/solid/cells/beds_source.h"
#include "procedurals/solid/cells/creases_source.h"
#include "procedurals/solid/cells/spots_source.h"

#include <cmath>

namespace scree {

namespace {

/// The share of space that randomly placed balls fill, one per unit of volume, with radii
/// smallest + (largest - smallest) u^2 for uniform u.
double filled_by(const SpotRecipe& recipe) {
    constexpr int steps = 256;
    double volume = 0;
    for (int i = 0; i < steps; ++i) {
        const double u = (i + 0.5) / steps;
        const double r = recipe.smallest + (recipe.largest - recipe.smallest) * u * u;
        volume += 4 * pi / 3 * r * r * r / steps;
    }
    return 1 - std::exp(-recipe.share * volume);
}

} // namespace

solid::Creases make_creases(const Params& params, unsigned use, const CreaseRecipe& recipe,
                            double scale) {
    return {make_cells(params, 30 + use, recipe.size * scale, recipe.stretch, recipe.jitter),
            as_float(recipe.softness)};
}

solid::Spots make_spots(const Params& params, unsigned use, const SpotRecipe& recipe,
                        double scale) {
    solid::Spots spots{};
    spots.cells = make_cells(params, 50 + use, recipe.size * scale, recipe.stretch, recipe.jitter);
    spots.share = as_float(recipe.share);
    spots.smallest = as_float(recipe.smallest);
    spots.largest = as_float(recipe.largest);
    spots.edge = as_float(recipe.edge);
    spots.mean = as_float(filled_by(recipe));
    return spots;
}

solid::Beds make_beds(const Params& params, unsigned use, const BedRecipe& recipe, double scale) {
    Random random(static_cast<std::uint64_t>(params.integer("seed")), Purpose::solid_cell,
                  70 + use);
    solid::Beds beds{};
    beds.rate = as_float(1 / (recipe.thickness * scale));
    beds.offset = as_float(random.uniform());
    beds.key = random.bits();
    beds.share = as_float(recipe.share);
    beds.softness = as_float(recipe.softness);
    beds.mean = as_float(0.65 * recipe.share); // amounts are uniform in [0.3, 1)
    return beds;
}

std::string shapes_program(const std::vector<const char*>& texts) {
    std::vector<const char*> all{beds_source, creases_source, spots_source};
    all.insert(all.end(), texts.begin(), texts.end());
    return cells_program(all);
}

} // namespace scree
