// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/box_grid.h"
#include "geometry/sampling/poisson_disk.h"

#include <array>

namespace scree::tests {

/// A set of samples with an independent implementation of the conflict rule of Kita & Miyata 2012
/// (eqs. 2 and 3): of the sampler's code only `class_distances` is used.
class DiskSet {
  public:
    DiskSet(const PoissonDiskProblem& problem, std::vector<DiskSample> samples);

    /// The number of conflicting pairs: for disks in rational arithmetic, for ellipses in long
    /// double with a tolerance of 1e-12 of an axis.
    std::size_t conflicts() const;

    /// The number of samples outside the domain, or whose angle or scale disagrees with the fields.
    std::size_t misplaced() const;

    /// The minimum over all samples of the distance to a new one, the larger of both directions, in
    /// units of the required distance. The sample can be added if this is at least 1.
    double margin(const DiskSample& added) const;

    /// A sample at a point of the domain; `turn` is a share of its class's range of rotation.
    DiskSample sample(const Vec2& position, std::uint32_t disk_class, double turn) const;

    const PoissonDiskProblem& problem() const { return problem_; }
    const std::vector<DiskSample>& samples() const { return samples_; }
    Vec2 period() const { return period_; } // of the torus
    double reach() const { return reach_; } // the longest distance at which samples can conflict

    /// The required distance of two samples of these classes, if all axes are equal [m].
    double distance(std::uint32_t a, std::uint32_t b) const {
        return distances_[a * problem_.classes.size() + b];
    }

  private:
    using Jacobian = std::array<double, 4>; // row by row; maps a sample's ellipse to the unit disk

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
