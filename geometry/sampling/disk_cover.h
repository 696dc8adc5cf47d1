// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/sampling/disk_metric.h"

#include <array>
#include <span>

namespace scree {

/// A placed sample with the properties of its ellipse that tests need.
struct PlacedDisk {
    DiskSample sample;
    QuadraticForm form;
    double reach = 0;    // longest semi-axis [m]
    double steepest = 0; // inverse of the shortest [1/m]
};

/// A placed sample, or an image of it on a torus, near a cell.
struct NearDisk {
    Vec2 position;
    std::uint32_t placed = 0;
};

/// A set of places where a sample of one class and with a range of turns may still fit.
struct DiskPart {
    ConvexPiece piece;
    double area = 0;
    double measure = 0; // the rate of its darts
    std::uint32_t disk_class = 0;
    Range turn;
    DiskMetric::Bounds bounds; // over the piece or a box around it, the samples' turns left out
};

/// Tests for conflicts between samples, and cuts from parts what samples cover.
class DiskCover {
  public:
    /// `doubt`: relative rounding error; limits are raised by it in tests for conflicts, and
    /// lowered by it where samples cover.
    DiskCover(const PoissonDiskProblem& problem, const DiskMetric& metric, double doubt);

    PlacedDisk placed(const DiskSample& sample) const;

    DiskPart part_of(const ConvexPiece& piece, std::uint32_t disk_class) const;
    void tighten_bounds(DiskPart& part) const;

    /// Whether a sample conflicts with none of `near`, which index `placed`.
    bool is_free(const PlacedDisk& disk, std::span<const NearDisk> near,
                 std::span<const PlacedDisk> placed) const;

    /// Takes from the part the places that samples near it cover, and those from which a sample
    /// would cover one of them. Returns whether anything is left.
    bool cut(DiskPart& part, std::span<const NearDisk> near,
             std::span<const PlacedDisk> placed) const;

    /// Whether the part is too small to be divided, or so small that a jump of the fields in it
    /// would remain in its parts.
    bool is_unresolved(const DiskPart& part) const;

    /// Two halves: across the turns where those move the ellipse's tip farther than the place does.
    std::array<DiskPart, 2> split(const DiskPart& part) const;

    double density(std::uint32_t disk_class) const { return density_[disk_class]; }
    double doubt() const { return doubt_; }

  private:
    double rate(const DiskPart& part) const;
    QuadraticForm form_of_all(const DiskPart& part) const;

    const DiskMetric& metric_;
    double doubt_;
    bool symmetric_; // all ellipses are disks of one scale: a is in b's where b is in a's
    std::vector<double> density_;         // rate per area of each class
    std::vector<QuadraticForm> constant_; // form of each class where it is the same everywhere
};

} // namespace scree
