// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/fibres/boundary.h"
#include "generators/fibres/fibres_settings.h"
#include "generators/fibres/segment_pairs.h"

namespace scree::fibres {

/// How far fibres are from what contact asks of them; depths are measured along the line between
/// the nearest points of two axes, with the radii there.
struct ContactMeasure {
    float deepest = 0;        // of two segments in each other [m]
    float outside = 0;        // of a vertex's ball beyond the bounds [m]
    std::size_t overlaps = 0; // pairs of segments in each other

    bool within(float depth) const { return deepest <= depth && outside <= depth; }
};

/// Moves overlapping fibres apart (position-based dynamics: Jacobi's iteration on contacts, rods
/// by Kugelstadt & Schoemer 2016, lengths by fast projection). A fibre sums its own moves only,
/// from places that no fibre changes meanwhile, so that results do not depend on threads.
class ContactSolver {
  public:
    /// All of it must outlive this. No rod may be without length.
    ContactSolver(Rods& rods, const Boundary& boundary, const ContactSettings& settings);

    /// From the first call on, contacts hold on by Coulomb's law. Bounds take back what slid on
    /// them in the step. Two fibres are linked as long as they touch: what they slid is taken back
    /// by at most friction times the move apart, and cut to that from step to step (Cundall &
    /// Strack 1979), or friction that balances a load would creep.
    void begin_step();

    /// The places of all vertices when the step began; empty without steps.
    const std::vector<Vec3>& start() const { return start_; }

    /// Measures where the rods are, and prepares the moves of `apply`.
    ContactMeasure measure();

    /// How deep a fibre was in others or outside when last measured [m].
    float depth_of(std::size_t fibre) const {
        return std::max(measures_[fibre].deepest, measures_[fibre].outside);
    }

    /// Makes the moves and restores `stiffness` of the shape, and lengths.
    void apply(float stiffness);

    std::size_t searches() const { return pairs_.searches(); }

  private:
    struct Moves;
    bool is_unmoved(std::size_t fibre) const;
    void gather(std::size_t fibre, Moves& moves, ContactMeasure& found);
    void keep_to_bounds(std::size_t fibre, std::uint32_t v, ContactMeasure& found);

    Rods& rods_;
    const Boundary& boundary_;
    float friction_;
    bool only_overlaps_ = false; // what touches without a margin is left alone, to come to an end
    SegmentPairs pairs_;
    std::vector<Vec3> moved_;              // where vertices go
    std::vector<Vec3> start_;              // of the step
    std::vector<std::vector<Vec3>> slid_;  // the slips of pairs by now
    std::vector<ContactMeasure> measures_; // of each fibre
    // Of each fibre, so that what contact leaves alone is not measured again: whether no move came
    // of its last measure, and whether it was moved after that.
    std::vector<std::uint8_t> free_, moves_;
};

/// What came of contact.
struct ContactResult {
    ContactMeasure measure;
    int iterations = 0;
    std::size_t searches = 0;
};

/// Repeats until nothing is deeper than the tolerance, with `stiffness` falling to 0 over the first
/// 50 iterations, or bending would balance contact; at most `max_iterations` times.
ContactResult resolve_contact(Rods& rods, const Boundary& boundary, const ContactSettings& settings,
                              const Context& context);

} // namespace scree::fibres
