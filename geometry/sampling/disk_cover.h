// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/sampling/disk_metric.h"

#include <array>
#include <span>

namespace scree {

/// A sample that was placed, and what is needed of its ellipse.
struct PlacedDisk {
    DiskSample sample;
    QuadraticForm form;
    double reach = 0;    // longest semi-axis [m]
    double steepest = 0; // inverse of the shortest [1/m]
};

/// A placed sample, and where its image lies that is at hand.
struct NearDisk {
    Vec2 position;
    std::uint32_t placed = 0;
};

/// Places, for one class and a range of turns, where a sample may still fit.
struct DiskPart {
    ConvexPiece piece;
    double area = 0;
    double measure = 0; // the rate of its darts
    std::uint32_t disk_class = 0;
    Range turn;
    DiskMetric::Bounds bounds; // over the piece or a box around it, without turn
};

/// What samples conflict with, and what they leave of parts.
class DiskCover {
  public:
    /// Limits are widened for conflicts and narrowed for covers by the share `doubt`.
    DiskCover(const PoissonDiskProblem& problem, const DiskMetric& metric, double doubt);

    PlacedDisk placed(const DiskSample& sample) const;

    DiskPart part_of(const ConvexPiece& piece, std::uint32_t disk_class) const;
    void tighten_bounds(DiskPart& part) const;

    /// Whether a sample conflicts with none of `near`, which index `placed`.
    bool is_free(const PlacedDisk& disk, std::span<const NearDisk> near,
                 std::span<const PlacedDisk> placed) const;

    /// Takes from the part what the samples near cover, and what would cover a sample near.
    /// Whether anything is left.
    bool cut(DiskPart& part, std::span<const NearDisk> near,
             std::span<const PlacedDisk> placed) const;

    /// Whether the part is too small to say more, or so small that a jump of the fields in it will
    /// not go away.
    bool is_unresolved(const DiskPart& part) const;

    /// Two halves: across the turns where those move the ellipse's tip farther than the place does.
    std::array<DiskPart, 2> split(const DiskPart& part) const;

    double density(std::uint32_t disk_class) const { return density_[disk_class]; }
    double doubt() const { return doubt_; }

  private:
    double rate(const DiskPart& part) const;
    QuadraticForm own_form(const DiskPart& part) const;

    const DiskMetric& metric_;
    double doubt_;
    bool symmetric_; // whether a conflicts with b just where b's ellipse holds a: all are disks
    std::vector<double> density_;         // rate per area of each class
    std::vector<QuadraticForm> constant_; // form of each class where it is the same everywhere
};

} // namespace scree
