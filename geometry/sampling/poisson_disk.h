// SPDX-License-Identifier: GPL-3.0-or-later
// Maximal Poisson-disk sets: points that keep their distance, and leave no room for another.
#pragma once

#include "core/context.h"
#include "geometry/plane/field.h"
#include "geometry/plane/region.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace scree {

/// Around each sample lies an ellipse into which no centre of its class may come; its semi-axes are
/// `length` along the sample's direction and `width` across it [m]. A disk where both are equal.
struct DiskClass {
    double length = 0;
    double width = 0;
    Range turn{0, 0}; // [rad] every sample draws an angle from it, which adds to the direction
};

/// One sample. `angle` [rad, from +x towards +z] is that of its ellipse's long axis, and `scale`
/// multiplied the axes there.
struct DiskSample {
    Vec2 position;
    std::uint32_t disk_class = 0;
    double angle = 0;
    double scale = 1;
};

/// What is to be filled with what. Two samples conflict when either lies in the other's ellipse
/// (Kita & Miyata 2012, eq. 2); of different classes the ellipses are reduced to the distances of
/// `class_distances`.
struct PoissonDiskProblem {
    std::shared_ptr<const Region> domain;   // where centres may lie
    bool torus = false;                     // the domain, a rectangle, tiles
    std::vector<DiskClass> classes;         // at least one
    std::shared_ptr<const Field> direction; // [deg] of the long axes; none: 0
    std::shared_ptr<const Field> scale;     // multiplies all axes, above 0; none: 1
    std::uint64_t seed = 0;
    int relax = 0;                // steps in which the samples move apart; not beside kept ones
    std::vector<DiskSample> kept; // are there already, and stay; the result leaves them out
    std::optional<Box2> window;   // new samples are looked for here only
};

/// The samples in an order that does not depend on the number of threads, and what it took.
struct PoissonDiskSet {
    std::vector<DiskSample> samples;
    std::uint64_t trials = 0;     // darts thrown
    std::uint64_t unresolved = 0; // pieces of the domain too small to tell whether they are covered
};

/// Throws Error for a torus that is narrower than four times the longest reach.
void check_torus(const PoissonDiskProblem& problem);

/// A maximal set: no two samples conflict, and no sample of any class could be added, except in
/// `unresolved` places, each narrower than 1e-9 of the ellipse there, or than 1e-3 where a field
/// jumps. Up to rounding it is distributed as if darts had been thrown uniformly over the domain,
/// one by one without end (random sequential adsorption), with the darts of each class in
/// proportion to the square of its ellipse's area. Relaxed sets (`relax_disks`) are also free of
/// conflicts and maximal, but more even. Throws Cancelled, and what `check_torus` throws.
PoissonDiskSet sample_poisson_disks(const PoissonDiskProblem& problem, const Context& context);

/// Distances between centres of classes, row by row: `distances[i]` on the diagonal, and between
/// different classes such that all together are as evenly spread as each alone (Wei 2010,
/// section 3.2, for points of `dimension`).
std::vector<double> class_distances(const std::vector<double>& distances, int dimension = 2);

} // namespace scree
