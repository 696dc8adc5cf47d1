// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/fill_solid.h"

#include "core/parallel.h"
#include "core/random.h"
#include "generators/pile/cover_target.h"
#include "geometry/mesh/offset_shells.h"

#include <algorithm>
#include <numeric>

namespace scree {

namespace {

// In distances between sites. Rice in a ball fills 0.27 of it with shells one such distance apart,
// 0.29 with a half and 0.30 with a quarter of it; from the outermost shell inwards only 0.23.
constexpr double shells_apart = 0.5;
constexpr double samples_apart = 0.5; // of the target's distance, in distances between shells
constexpr std::size_t measuring_points = 32768;

} // namespace

double shell_spacing(std::span<const PileKind> kinds) {
    double least = std::numeric_limits<double>::max();
    for (const PileKind& kind : kinds)
        least = std::min(least, 2 * kind.distribution_radius());
    return shells_apart * least;
}

PileTurns turns_of_shell(const PileTurns& turns, std::size_t shell) {
    PileTurns own = turns;
    own.seed = derived_seed(turns.seed, Purpose::pile_shell, shell);
    return own;
}

std::size_t fill_solid(PlacedBodies& pile, const Mesh& target, const PileTurns& turns,
                       std::vector<BodySite> sites, const SolidFill& fill,
                       const InsertionSettings& settings, const Context& context) {
    const double spacing = shell_spacing(turns.kinds);
    const SignedDistanceGrid solid(target, samples_apart * spacing);
    const std::vector<OffsetShell> shells = offset_shells(solid, spacing, fill.shells - 1);
    std::size_t tried = 0;
    for (std::size_t i = shells.size(); i-- > 0;) {
        const PileTurns own = turns_of_shell(turns, i);
        InsertionSettings below = settings;
        below.ceiling = shells[i].depth;
        const Mesh& surface = shells[i].surface;
        tried +=
            pile_up(pile, surface, own, pile_sites(surface, own, context), below, 0, context).tried;
    }
    return tried +
           pile_up(pile, target, turns, std::move(sites), settings, fill.cover, context).tried;
}

double filled_share(const PlacedBodies& pile, const Mesh& target, std::uint64_t seed) {
    const Box3 box = bounds(target);
    const SignedDistanceGrid solid(target, double(box.size().length()) / 200);
    // For each point whether it is in the target, and in a component.
    std::vector<std::array<std::uint8_t, 2>> hits(measuring_points);
    parallel_for(measuring_points, 64, [&](std::size_t i) {
        Random random(seed, Purpose::pile_fill, i);
        Vec3 p = box.min;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] += box.size()[axis] * random.uniform_float();
        if (solid.at(p) >= 0)
            return;
        hits[i][0] = 1;
        pile.hash.near(Imath::V3d(p), 0, [&](std::uint32_t index) {
            const PlacedBody& placed = pile.all[index];
            const Vec3 own =
                Vec3(Imath::V3d(p) - placed.pose.centre) * placed.pose.world_from_body.transposed();
            if (hits[i][1] == 0 && pile.body(placed).distance.at(own) < 0)
                hits[i][1] = 1;
        });
    });
    double inside = 0;
    double filled = 0;
    for (const auto& hit : hits) {
        inside += hit[0];
        filled += hit[1];
    }
    return inside > 0 ? filled / inside : 0;
}

} // namespace scree
