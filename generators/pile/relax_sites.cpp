// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/relax_sites.h"

#include "core/random.h"
#include "geometry/mesh/offset_shells.h"
#include "geometry/sampling/surface_disks.h"

#include <algorithm>

namespace scree {

namespace {

// How many samples a maximal set on a plane has in a square as wide as their distance.
constexpr double samples_per_square = 0.70;
constexpr double shells_apart = 0.8; // in distances between samples

/// Means over the kinds, by weight.
struct MeanKind {
    double volume = 0;
    double range = 0;
    double radius = 0;
};

MeanKind mean_kind(std::span<const PileKind> kinds, std::span<const MassProperties> masses) {
    MeanKind mean;
    double weights = 0;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        // A sheet has hardly any volume but needs the room of a ball.
        const double round = 2 * kinds[k].unit_radius;
        const double volume = std::max(masses[k].mass, 4 * pi / 3 * round * round * round);
        weights += kinds[k].weight;
        mean.volume += kinds[k].weight * volume;
        mean.range += kinds[k].weight * kinds[k].range();
        mean.radius += kinds[k].weight * std::max(kinds[k].body->radius, round);
    }
    return {mean.volume / weights, mean.range / weights, mean.radius / weights};
}

} // namespace

std::vector<PlacedBody> strewn(const Mesh& target, const SignedDistanceGrid& distance,
                               const PileTurns& turns, std::span<const MassProperties> masses,
                               const RelaxSettings& settings, const Context& context) {
    const MeanKind mean = mean_kind(turns.kinds, masses);
    std::vector<PlacedBody> placed;
    const auto strew = [&](const Mesh& surface, double apart, std::uint64_t shell) {
        const SurfaceDiskSet set =
            sample_surface_disks({.mesh = &surface,
                                  .distances = {apart},
                                  .seed = derived_seed(turns.seed, Purpose::pile_strew, shell)},
                                 context);
        for (std::size_t i = 0; i < set.samples.size(); ++i) {
            const std::uint64_t number = std::uint64_t{1} << 62 | shell << 32 | i;
            Random random(turns.seed, Purpose::pile_strew, number);
            const BodySite site =
                turns.site(set.samples[i].position, smooth_normal(surface, set.samples[i]),
                           kind_at(turns.kinds, random.uniform()), number);
            const double range = turns.kinds[site.body].range();
            placed.push_back(site.at(settings.solid ? 0 : random.uniform(0, range)));
        }
    };
    const double share_of_volume = settings.density / mean.volume;
    if (!settings.solid) {
        // Components reach beyond the range in which their centres are.
        const double per_area = share_of_volume * (mean.range + mean.radius);
        strew(target, std::sqrt(samples_per_square / per_area), 0);
        return placed;
    }
    const double apart = std::cbrt(samples_per_square / shells_apart / share_of_volume);
    for (std::uint64_t shell = 0;; ++shell) {
        const double depth = (double(shell) + 0.5) * shells_apart * apart;
        const Mesh surface = level_surface(distance, -depth);
        if (surface.triangles.empty())
            break;
        strew(surface, apart, shell);
    }
    return placed;
}

} // namespace scree
