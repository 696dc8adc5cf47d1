// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "geometry/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace scree {

/// A sample on a mesh; `normal` is that of its triangle, of length 1.
struct SurfaceSample {
    Imath::V3d position;
    Vec3 normal;
    std::uint32_t triangle = 0;
    std::uint32_t disk_class = 0;
};

/// What is to be filled: samples of class i stay `distances[i]` [m] apart in space, and those of
/// different classes as `class_distances` says.
struct SurfaceDiskProblem {
    const Mesh* mesh = nullptr;
    std::vector<double> distances; // at least one
    std::uint64_t seed = 0;
};

/// As PoissonDiskSet.
struct SurfaceDiskSet {
    std::vector<SurfaceSample> samples;
    std::uint64_t trials = 0;
    std::uint64_t unresolved = 0;
};

/// A maximal set on the surface of a mesh, open or closed: no two samples are nearer than their
/// distance, measured straight through space (Cline et al. 2009), and no point of any triangle is
/// left where another sample could lie. Distributed as darts thrown uniformly over the surface, as
/// `sample_poisson_disks`. Throws Cancelled, and Error for a mesh without area or with numbers that
/// are not finite, and for a distance so small that there would be over 2^27 samples.
SurfaceDiskSet sample_surface_disks(const SurfaceDiskProblem& problem, const Context& context);

/// The normal at a sample of the mesh, as `smooth_normal` of a place.
inline Vec3 smooth_normal(const Mesh& mesh, const SurfaceSample& sample) {
    return smooth_normal(mesh, sample.triangle, sample.position, sample.normal);
}

} // namespace scree
