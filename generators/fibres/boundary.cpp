// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/boundary.h"

#include <algorithm>

namespace scree::fibres {

SignedDistanceGrid boundary_grid(const Mesh& mesh, bool sheet) {
    constexpr double steps = 96; // along the longest side
    constexpr std::size_t most_samples = std::size_t{1} << 22;
    const Vec3 size = bounds(mesh).size();
    const double longest = std::max({size.x, size.y, size.z});
    const double step = longest / steps;
    return SignedDistanceGrid(mesh, step, sheet ? 1e-6 * longest : 0, most_samples, 6 * step);
}

void Boundary::stay_inside(std::shared_ptr<const Mesh> mesh,
                           std::shared_ptr<const SignedDistanceGrid> grid) {
    add(std::move(mesh), std::move(grid), false, 1);
}

void Boundary::stay_outside(std::shared_ptr<const Mesh> mesh) {
    const bool sheet = !inspect(*mesh).closed();
    auto grid = std::make_shared<const SignedDistanceGrid>(boundary_grid(*mesh, sheet));
    add(std::move(mesh), std::move(grid), sheet, -1);
}

void Boundary::add(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const SignedDistanceGrid> grid,
                   bool sheet, float sign) {
    const auto step = static_cast<float>(grid->step());
    auto surface = std::make_shared<const NearestSurface>(*mesh);
    auto sides = sheet ? nullptr : std::make_shared<const SideNormals>(*mesh);
    const bool inside_out = !sheet && volume(*mesh) < 0;
    solids_.push_back({.mesh = std::move(mesh),
                       .grid = std::move(grid),
                       .surface = std::move(surface),
                       .sides = std::move(sides),
                       .sign = sign,
                       .step = step,
                       .sheet = sheet,
                       .inside_out = inside_out});
}

Excess Boundary::Solid::excess(const Vec3& p, float keep, float coarse) const {
    Excess found = straight_excess(p, keep, coarse);
    if (sheet || sign < 0 || found.distance < keep / 4)
        return found;
    // Where the shape is thinner than a fibre, each side would send it to the other for ever.
    const Vec3 beyond = p + found.back;
    const Excess other = straight_excess(beyond, keep, grid->at(beyond));
    if (other.distance > keep / 4 && other.outward.dot(found.outward) < 0)
        if (const auto inside = deeper_inside(p, keep)) {
            const Vec3 way = *inside - p;
            found.back = way * std::min(1.0F, keep / way.length());
        }
    return found;
}

/// The nearest sample of the grid that is deeper inside; none if there is none nearby.
std::optional<Vec3> Boundary::Solid::deeper_inside(const Vec3& p, float depth) const {
    constexpr int most_cells = 12;
    const VoxelGrid& voxels = grid->grid();
    const Vec3 first(voxels.centre(0, 0, 0));
    std::array<int, 3> low{};
    std::array<int, 3> high{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto cell = static_cast<int>((p[axis] - first[axis]) / static_cast<float>(step));
        low[std::size_t(axis)] = std::max(cell - most_cells, 0);
        high[std::size_t(axis)] = std::min(cell + most_cells, voxels.count[std::size_t(axis)] - 1);
    }
    std::optional<Vec3> best;
    for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j)
            for (int i = low[0]; i <= high[0]; ++i)
                if (grid->samples()[voxels.index(i, j, k)] < -depth) {
                    const Vec3 place(voxels.centre(i, j, k));
                    if (!best || (place - p).length2() < (*best - p).length2())
                        best = place;
                }
    return best;
}

Excess Boundary::Solid::straight_excess(const Vec3& p, float keep, float coarse) const {
    const float doubt = step / 2;
    // Where the grid is sure that p may be there, only what is nearer than `keep` matters.
    const float within = sign * coarse < -doubt ? keep : std::numeric_limits<float>::infinity();
    const auto near = surface->nearest_within(Imath::V3d(p), within);
    if (!near)
        return {};
    const auto distance = static_cast<float>(near->distance);
    const Vec3 way = p - Vec3(near->position);
    const float facing = inside_out ? -1 : 1;
    const Vec3 normal = near->normal * facing;
    const auto is_behind = [&] {
        const bool behind = way.dot(sides->at(near->triangle, Vec3(near->position))) * facing < 0;
        // Where facets fold over each other normals mislead.
        if (behind != (coarse < 0) && distance > keep / 4)
            return std::abs(winding_number(*mesh, Imath::V3d(p))) > 0.5;
        return behind;
    };
    const bool inside = !sheet && (std::abs(coarse) > doubt ? coarse < 0 : is_behind());
    // Away from the surface on p's side of it; next to the surface its normal is more exact.
    Vec3 away = inside ? -normal : normal;
    if (distance > 1e-3F * keep)
        away = way / distance;
    else if (sheet && way.dot(away) < 0)
        away = -away;
    const float outside = inside ? -distance : distance;
    const Vec3 outward = inside ? -away : away; // of the mesh
    const float excess = sign * outside + keep;
    return {excess, outward * sign, outward * (-sign * excess)};
}

} // namespace scree::fibres
