// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/rock_kinds.h"

#include "core/parallel.h"
#include "core/random.h"
#include "geometry/rock/rock_body.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree::rocks {

namespace {

constexpr std::size_t unique_rocks = 30; // the largest ones, which are looked at

/// Rocks from a share of the largest one's size on, but no more than the first so many, are drawn
/// at a level.
struct LevelRule {
    int level;
    double least_size;
    std::size_t most;
};
constexpr LevelRule rules[] = {{16, 0.3, 60}, {8, 0.1, 1000}};
constexpr int coarsest = 4;

std::size_t unique_count(const RocksSettings& settings, std::span<const double> sizes) {
    return settings.unique ? sizes.size() : std::min(unique_rocks, sizes.size());
}

} // namespace

int level_of(const RocksSettings& settings, std::size_t rank, double relative_size) {
    if (settings.level > 0)
        return settings.level;
    for (const LevelRule& rule : rules)
        if (rank < rule.most && relative_size >= rule.least_size)
            return rule.level;
    return coarsest;
}

RockSettings settings_of_kind(const RocksSettings& settings, std::uint64_t kind) {
    Random random(settings.seed, Purpose::rock_kind, kind);
    RockSettings rock = settings.rock;
    const WideVec3 vary = normal_vector(random);
    rock.b_over_a = std::clamp(rock.b_over_a + settings.spread * vary.x, least_axis, 1.0);
    rock.c_over_a = std::clamp(rock.c_over_a + settings.spread * vary.y, least_axis, rock.b_over_a);
    rock.wear = std::clamp(rock.wear + settings.wear_spread * vary.z, 0.0, 1.0);
    rock.seed = random.bits64();
    return rock;
}

RockKinds::RockKinds(const RocksSettings& settings, std::span<const double> sizes)
    : unique_(unique_count(settings, sizes)),
      shared_(static_cast<std::size_t>(settings.prototypes)) {
    std::vector<int> levels; // of each surface
    for (std::size_t i = 0; i < unique_; ++i) {
        levels.push_back(level_of(settings, i, sizes[i] / sizes.front()));
        kinds_.push_back(shared_ + i);
    }
    for (std::size_t i = unique_; i < sizes.size(); ++i) {
        const int level = level_of(settings, i, sizes[i] / sizes.front());
        if (i == unique_ || level != levels.back())
            for (std::size_t kind = 0; kind < shared_; ++kind) {
                levels.push_back(level);
                kinds_.push_back(kind);
            }
        first_of_rock_.push_back(static_cast<std::uint32_t>(levels.size() - shared_));
    }
    surfaces_.resize(levels.size());
    parallel_for(levels.size(), 1, [&](std::size_t s) {
        surfaces_[s] = make_rock_surface(settings_of_kind(settings, kinds_[s]), levels[s],
                                         fmt::format("rock_{}_{}", kinds_[s] + 1, levels[s]));
    });
}

std::uint32_t RockKinds::surface_of(std::size_t i, std::uint32_t kind) const {
    if (i < unique_)
        return static_cast<std::uint32_t>(i);
    return first_of_rock_[i - unique_] + kind % static_cast<std::uint32_t>(shared_);
}

} // namespace scree::rocks
