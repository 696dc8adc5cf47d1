// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/figures/layout.h"
#include "geometry/figures/layout_problem.h"

namespace scree {

/// What has been placed so far, with an index of neighbours: uniform grids, one per octave of
/// sizes, each cell as wide as the largest element of its octave, so that a query visits 3 x 3
/// cells of elements of about its size and few cells of larger ones.
class Placements {
  public:
    /// `problem` must outlive this.
    explicit Placements(const LayoutProblem& problem);

    /// Places the dart's element if it lies in the domain and overlaps nothing.
    bool try_place(const Dart& dart);

    /// Whether it could be placed; counts pairs tested. Threads may share it.
    bool is_free(const Dart& dart, std::uint64_t& queries) const;

    /// The elements whose circles, margins included, come within `radius` of the point, in an
    /// unspecified order; on a torus the nearest image of each. Threads may share it.
    void gather(const Vec2& point, double radius, std::vector<std::uint32_t>& elements) const;

    /// Whether no element's position is nearer than `distance` [m].
    bool keeps_distance(const Vec2& position, double distance) const;

    /// Places it without a test.
    void place(const Dart& dart);

    std::size_t size() const { return darts_.size(); }
    const std::vector<Dart>& darts() const { return darts_; }
    bool full() const { return size() >= problem_.max_count; }
    std::uint64_t queries() const { return queries_; } // pairs tested with `overlap`

    /// Everything placed, in order of placement.
    Layout layout(std::shared_ptr<const Region> domain) const;

  private:
    struct Level {
        double cell = 0; // at least as wide as the widest element
        Vec2 size;       // of a cell: on a torus they divide it evenly
        int width = 0;
        int height = 0;
        std::vector<std::uint32_t> first; // per cell: an element, or nobody
    };
    Level& level_of(double radius);
    template <class Visit>
    bool any_near(const Vec2& point, double radius, const Visit& visit) const;

    const LayoutProblem& problem_;
    double clearance_;
    double smallest_cell_ = 0;
    std::vector<Level> levels_;
    std::vector<Dart> darts_;
    std::vector<double> radii_;       // per element: of its circumscribed circle and margin [m]
    std::vector<std::uint32_t> next_; // per element: the next one in its cell
    std::uint64_t queries_ = 0;
};

} // namespace scree
