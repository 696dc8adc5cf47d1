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
    const bool inside_out = !sheet && volume(*mesh) < 0;
    solids_.push_back({.mesh = std::move(mesh),
                       .grid = std::move(grid),
                       .surface = std::move(surface),
                       .sign = sign,
                       .step = step,
                       .sheet = sheet,
                       .inside_out = inside_out});
}

Excess Boundary::Solid::excess(const Vec3& p, float keep, float coarse) const {
    const float doubt = step / 2;
    // Where the grid is sure that p may be there, only what is nearer than `keep` matters.
    const float within = sign * coarse < -doubt ? keep : std::numeric_limits<float>::infinity();
    const auto near = surface->nearest_within(Imath::V3d(p), within);
    if (!near)
        return {};
    const auto distance = static_cast<float>(near->distance);
    const Vec3 way = p - Vec3(near->position);
    const Vec3 normal = inside_out ? -near->normal : near->normal;
    const bool inside = !sheet && (std::abs(coarse) > doubt ? coarse < 0 : way.dot(normal) < 0);
    // Away from the surface on p's side of it; next to the surface its normal is more exact.
    Vec3 away = inside ? -normal : normal;
    if (distance > 1e-3F * keep)
        away = way / distance;
    else if (sheet && way.dot(away) < 0)
        away = -away;
    const float outside = inside ? -distance : distance;
    const Vec3 outward = inside ? -away : away; // of the mesh
    return {sign * outside + keep, outward * sign};
}

} // namespace scree::fibres
