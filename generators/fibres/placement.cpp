// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/placement.h"

#include "geometry/sampling/surface_disks.h"
#include "geometry/sampling/surface_points.h"

namespace scree::fibres {

Interior::Interior(const SignedDistanceGrid& shape, double depth)
    : shape_(&shape), depth_(static_cast<float>(depth)) {
    const VoxelGrid& grid = shape.grid();
    const std::vector<float>& samples = shape.samples();
    for (int k = 0; k + 1 < grid.count[2]; ++k)
        for (int j = 0; j + 1 < grid.count[1]; ++j)
            for (int i = 0; i + 1 < grid.count[0]; ++i) {
                float least = samples[grid.index(i, j, k)];
                for (int corner = 1; corner < 8; ++corner)
                    least =
                        std::min(least, samples[grid.index(i + (corner & 1), j + (corner >> 1 & 1),
                                                           k + (corner >> 2))]);
                if (least < -depth_)
                    cells_.push_back(static_cast<std::uint32_t>(grid.index(i, j, k)));
            }
}

Vec3 Interior::draw(Random& random) const {
    const VoxelGrid& grid = shape_->grid();
    const auto nx = std::uint32_t(grid.count[0]);
    const auto layer = nx * std::uint32_t(grid.count[1]);
    for (;;) {
        const std::uint32_t cell = cells_[random.below(static_cast<std::uint32_t>(cells_.size()))];
        const std::uint32_t in_layer = cell % layer;
        const Imath::V3d offset(random.uniform(), random.uniform(), random.uniform());
        const Imath::V3d first =
            grid.centre(int(in_layer % nx), int(in_layer / nx), int(cell / layer));
        const Vec3 p = Vec3(first + offset * grid.side);
        if (shape_->at(p) < -depth_)
            return p;
    }
}

Roots roots_on(const Mesh& mesh, std::size_t count, std::uint64_t seed, const Context& context) {
    Roots roots{.all = {}, .spacing = spacing_for(mesh, double(count))};
    SurfaceDiskSet set;
    for (;; roots.spacing *= 0.97) {
        set = sample_surface_disks({.mesh = &mesh, .distances = {roots.spacing}, .seed = seed},
                                   context);
        if (set.samples.size() >= count)
            break;
    }
    Random random(seed, Purpose::fibre_root);
    roots.all.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto left = static_cast<std::uint32_t>(set.samples.size() - i);
        std::swap(set.samples[i], set.samples[i + random.below(left)]);
        const SurfaceSample& sample = set.samples[i];
        roots.all.push_back({Vec3(sample.position), smooth_normal(mesh, sample)});
    }
    return roots;
}

} // namespace scree::fibres
