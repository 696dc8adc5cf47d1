// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/nearest_surface.h"
#include "geometry/mesh/side_normals.h"
#include "geometry/mesh/signed_distance_grid.h"

#include <memory>
#include <optional>
#include <vector>

namespace scree::fibres {

/// Where a point is too far out of what bounds fibres.
struct Excess {
    float distance = 0; // beyond where it may be [m]
    Vec3 outward;       // the steepest way further out, of length 1
    Vec3 back;          // what takes it back [m]
};

/// What bounds fibres: shapes that they stay in, solids and sheets that they stay out of, a floor.
class Boundary {
  public:
    /// Stay inside of a closed mesh, of which this is the distance grid.
    void stay_inside(std::shared_ptr<const Mesh> mesh,
                     std::shared_ptr<const SignedDistanceGrid> grid);
    /// Stay out of a mesh: a solid if it is closed, else a sheet without thickness.
    void stay_outside(std::shared_ptr<const Mesh> mesh);
    void stay_above(double height) { floor_ = static_cast<float>(height); }

    /// Calls found(excess) for each bound that p is nearer to than `keep` [m], or beyond. Bounds
    /// are asked in turn, of the place where `p` is by then. Near meshes distances are exact.
    template <class Found>
    void each_excess(const Vec3& p, float keep, const Found& found) const {
        if (floor_)
            if (const float below = *floor_ + keep - p.y; below > 0)
                found(Excess{below, Vec3(0, -1, 0), Vec3(0, below, 0)});
        for (const Solid& solid : solids_)
            if (const float coarse = solid.grid->at(p); solid.sign * coarse > -keep - solid.step)
                if (const Excess excess = solid.excess(p, keep, coarse); excess.distance > 0)
                    found(excess);
    }

    /// By how much p is beyond the farthest of the bounds brought in by `keep` [m]; at least 0.
    float excess(const Vec3& p, float keep) const {
        float most = 0;
        each_excess(p, keep, [&](const Excess& e) { most = std::max(most, e.distance); });
        return most;
    }

  private:
    struct Solid {
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const SignedDistanceGrid>
            grid; // tells inside from outside, and what is far from the surface
        std::shared_ptr<const NearestSurface> surface;
        std::shared_ptr<const SideNormals> sides; // of no sheet
        float sign = 1;                           // 1: stay inside; -1: stay outside
        float step = 0;                           // of the grid, more than its error [m]
        bool sheet = false;
        bool inside_out = false; // the normals point inwards

        Excess excess(const Vec3& p, float keep, float coarse) const;
        Excess straight_excess(const Vec3& p, float keep, float coarse) const;
        std::optional<Vec3> deeper_inside(const Vec3& p, float depth) const;
    };
    void add(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const SignedDistanceGrid> grid,
             bool sheet, float sign);

    std::vector<Solid> solids_;
    std::optional<float> floor_;
};

/// The distance grid of a target or a container, coarse: near the surface distances are exact.
SignedDistanceGrid boundary_grid(const Mesh& mesh, bool sheet);

} // namespace scree::fibres
