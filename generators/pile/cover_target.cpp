// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/cover_target.h"

#include "core/random.h"

#include <algorithm>
#include <optional>

namespace scree {

namespace {

// In radii: less than the thickness of a component, so that each layer is filled before the next
// one lies on it.
constexpr double level_height = 1;
constexpr int most_passes = 2;      // over the gaps of each level
constexpr double least_gain = 0.02; // share of the tried gaps that a pass fills, or it is the last
constexpr std::size_t measuring_rays = 8192;
constexpr std::size_t rays_per_site = 3;

double hidden_share(std::size_t open, std::size_t all) {
    return all > 0 ? 1 - double(open) / double(all) : 1;
}

/// The rays along which the target's surface can still be seen.
class Gaps {
  public:
    Gaps(const Mesh& target, const PileTurns& turns, std::size_t count, double cover)
        : turns_(turns), rays_(outside_rays(target, count, turns.seed, 0)), all_(rays_.size()),
          cover_(cover) {}

    /// Drops the rays that the pile hides by now; returns whether too many are left.
    bool remain(const PlacedBodies& pile) {
        rays_ = open_rays(pile, rays_);
        return hidden_share(rays_.size(), all_) < cover_;
    }

    /// A new site at the origin of each ray, with a rotation of its own.
    std::vector<BodySite> sites() {
        std::vector<BodySite> out;
        for (const OutsideRay& ray : rays_) {
            const std::uint64_t number = std::uint64_t{1} << 63 | made_++;
            const std::uint32_t kind =
                kind_at(turns_.kinds, Random(turns_.seed, Purpose::pile_order, number).uniform());
            out.push_back(turns_.site(ray.origin, ray.normal, kind, number));
        }
        return out;
    }

  private:
    PileTurns turns_;
    std::vector<OutsideRay> rays_;
    std::size_t all_;
    double cover_;
    std::uint64_t made_ = 0;
};

double levels_of(std::span<const PileKind> kinds, double sink) {
    double levels = 1;
    for (const PileKind& kind : kinds)
        levels =
            std::max(levels, std::ceil((kind.range() / kind.body->radius + sink) / level_height));
    return levels;
}

} // namespace

PileUp pile_up(PlacedBodies& pile, const Mesh& target, const PileTurns& turns,
               std::vector<BodySite> sites, const InsertionSettings& settings, double cover,
               const Context& context) {
    const std::vector<double> ranges = ranges_of(turns.kinds);
    PileUp result{.tried = sites.size(), .covered = cover <= 0};
    std::optional<Gaps> gaps;
    if (cover > 0)
        gaps.emplace(target, turns, std::max(measuring_rays, rays_per_site * sites.size()), cover);
    std::vector<InsertionCandidate> waiting =
        candidates_at(std::move(sites), pile.shapes, ranges, settings);
    const auto levels = static_cast<std::int64_t>(levels_of(turns.kinds, settings.sink));
    for (std::int64_t n = 1; n <= levels; ++n) {
        context.report("pile", double(n - 1) / double(levels));
        const double level = double(n) * level_height - settings.sink;
        insert_up_to(level, pile, waiting, settings, context);
        for (int pass = 0; gaps && pass < most_passes; ++pass) {
            if (!gaps->remain(pile)) {
                result.covered = true;
                return result;
            }
            std::vector<InsertionCandidate> fresh =
                candidates_at(gaps->sites(), pile.shapes, ranges, settings);
            const std::size_t before = pile.all.size();
            const std::size_t count = fresh.size();
            insert_up_to(level, pile, fresh, settings, context);
            result.tried += count;
            if (double(pile.all.size() - before) < least_gain * double(count))
                break;
        }
    }
    return result;
}

double measured_cover(const PlacedBodies& pile, const Mesh& target, std::uint64_t seed) {
    const std::vector<OutsideRay> rays = outside_rays(target, measuring_rays, seed, 1);
    return hidden_share(open_rays(pile, rays).size(), rays.size());
}

} // namespace scree
