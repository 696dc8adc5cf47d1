// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/box_grid.h"
#include "geometry/sampling/poisson_disk.h"

#include <array>

namespace scree::tests {

/// Samples under the rule of conflict as Kita & Miyata 2012 state it (eq. 2 and 3), written down
/// again: of the sampler only `class_distances` is used.
class DiskSet {
  public:
    DiskSet(const PoissonDiskProblem& problem, std::vector<DiskSample> samples);

    /// Pairs that conflict, by brute force: of equal axes in rational numbers, of ellipses in long
    /// double up to 1e-12 of an axis.
    std::size_t conflicts() const;

    /// Samples outside the domain, or with an angle or a scale that the fields do not give.
    std::size_t misplaced() const;

    /// The least distance from a new sample to any other, the longer of both ways round, in units
    /// of what keeps them apart: it could be added where this is 1 or more.
    double margin(const DiskSample& added) const;

    /// A sample at a point of the domain, turned by a share of its class's range.
    DiskSample sample(const Vec2& position, std::uint32_t disk_class, double turn) const;

    const PoissonDiskProblem& problem() const { return problem_; }
    const std::vector<DiskSample>& samples() const { return samples_; }
    Vec2 period() const { return period_; } // of the torus
    double reach() const { return reach_; } // the longest distance at which samples can conflict

    /// What keeps two samples of these classes apart where all axes are equal [m].
    double distance(std::uint32_t a, std::uint32_t b) const {
        return distances_[a * problem_.classes.size() + b];
    }

  private:
    using Jacobian = std::array<double, 4>; // row by row; takes a sample's ellipse to a unit disk

    static Jacobian jacobian(const DiskClass& of, double angle, double scale);
    double squared_distance(const Jacobian& from, std::uint32_t class_from, std::uint32_t class_to,
                            const Vec2& offset) const;
    bool round_conflict(std::size_t i, std::size_t j) const;
    bool ellipse_conflict(std::size_t i, std::size_t j) const;
    Vec2 wrapped(Vec2 offset) const;
    std::vector<Box2> boxes() const;

    const PoissonDiskProblem& problem_;
    std::vector<DiskSample> samples_;
    std::vector<Jacobian> jacobians_;
    std::vector<double> distances_;
    Vec2 period_;
    double reach_ = 0;
    bool round_ = true;
    std::unique_ptr<BoxGrid> grid_;
};

} // namespace scree::tests
