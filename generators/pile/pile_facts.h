// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/pile/pile_kind.h"
#include "geometry/bodies/placed_bodies.h"
#include "model/aggregate.h"

#include <chrono>

namespace scree {

/// The seconds that each stage of a bake takes.
class StageTimes {
  public:
    /// Ends the stage that began with the end of the one before.
    void end(const char* name);

    /// Adds the time of each stage and of all.
    void add_to(Facts& facts) const;

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    Facts seconds_;
};

/// Adds how many there are of each component, if there are several.
void add_counts(const PlacedBodies& pile, std::span<const PileKind> kinds, Facts& facts);

/// The pile with all components moved back to their sites.
PlacedBodies at_their_sites(const PlacedBodies& pile);

/// Adds how deep components are in each other, in the finished pile and in that they `start`ed
/// from, measured at `most` of them.
void add_overlap(const PlacedBodies& pile, const PlacedBodies& start, std::size_t most,
                 Facts& facts);

} // namespace scree
