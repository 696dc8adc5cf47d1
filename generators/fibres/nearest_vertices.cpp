// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/nearest_vertices.h"

#include "core/parallel.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace scree::fibres {

namespace {

/// One vertex at each place, with a smooth normal that points outwards.
Mesh smooth_surface(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weld(mesh);
    Mesh smooth;
    std::vector<std::uint32_t> index(welded.size());
    for (std::size_t i = 0; i < welded.size(); ++i)
        if (welded[i] == i) {
            index[i] = static_cast<std::uint32_t>(smooth.positions.size());
            smooth.positions.push_back(mesh.positions[i]);
        }
    smooth.triangles = mesh.triangles;
    for (Mesh::Triangle& triangle : smooth.triangles)
        for (std::uint32_t& corner : triangle)
            corner = index[welded[corner]];
    compute_normals(smooth, pi);
    if (volume(smooth) < 0)
        for (Vec3& normal : smooth.normals)
            normal = -normal;
    return smooth;
}

/// Halves a cube down to the grid's cells, each part with those of the whole's vertices that can be
/// nearest to a point in it.
class Division {
  public:
    Division(const Mesh& mesh, NearestVertices& out)
        : mesh_(mesh), out_(out), cells_(std::size_t(out.side) * out.side * out.side) {
        std::vector<std::int32_t> all(mesh.positions.size());
        std::iota(all.begin(), all.end(), 0);
        divide({0, 0, 0}, NearestVertices::side, all);
    }

    void write() {
        out_.first.assign(cells_.size() + 1, 0);
        for (std::size_t i = 0; i < cells_.size(); ++i)
            out_.first[i + 1] = out_.first[i] + static_cast<std::int32_t>(cells_[i].size());
        out_.nearest.reserve(std::size_t(out_.first.back()));
        for (const std::vector<std::int32_t>& cell : cells_)
            out_.nearest.insert(out_.nearest.end(), cell.begin(), cell.end());
    }

  private:
    using Corner = std::array<int, 3>;

    void divide(const Corner& low, int cells, const std::vector<std::int32_t>& among) {
        const std::vector<std::int32_t> kept = possible(low, cells, among);
        if (cells == 1) {
            constexpr auto n = std::size_t(NearestVertices::side);
            cells_[(std::size_t(low[2]) * n + std::size_t(low[1])) * n + std::size_t(low[0])] =
                kept;
            return;
        }
        const int half = cells / 2;
        parallel_for(8, 1, [&](std::size_t part) {
            Corner corner = low;
            for (std::size_t axis = 0; axis < 3; ++axis)
                corner[axis] += (part >> axis & 1U) != 0 ? half : 0;
            divide(corner, half, kept);
        });
    }

    std::vector<std::int32_t> possible(const Corner& low, int cells,
                                       const std::vector<std::int32_t>& among) const {
        const float width = out_.cell * static_cast<float>(cells);
        const Vec3 centre = out_.corner +
                            Vec3(float(low[0]), float(low[1]), float(low[2])) * out_.cell +
                            Vec3(width / 2);
        const auto distance2 = [&](std::int32_t v) {
            return (mesh_.positions[std::size_t(v)] - centre).length2();
        };
        const std::int32_t nearest = *std::ranges::min_element(among, {}, distance2);
        // Half-spaces between two vertices are convex: one is never nearest if the other is nearer
        // to all of the cube's corners.
        const auto can_be_nearest = [&](std::int32_t v) {
            const Vec3 apart =
                mesh_.positions[std::size_t(v)] - mesh_.positions[std::size_t(nearest)];
            const float most = width * (std::abs(apart.x) + std::abs(apart.y) + std::abs(apart.z));
            return distance2(v) - distance2(nearest) <= most * (1 + 1e-4F);
        };
        std::vector<std::int32_t> kept;
        std::ranges::copy_if(among, std::back_inserter(kept), can_be_nearest);
        return kept;
    }

    const Mesh& mesh_;
    NearestVertices& out_;
    std::vector<std::vector<std::int32_t>> cells_;
};

} // namespace

NearestVertices::NearestVertices(const Mesh& mesh, double margin) {
    const Mesh smooth = smooth_surface(mesh);
    const Box3 box = bounds(smooth);
    const Vec3 extent = box.size();
    const float width = std::max({extent.x, extent.y, extent.z}) + 2 * static_cast<float>(margin);
    corner = box.center() - Vec3(width / 2);
    cell = width / side;
    surface.reserve(6 * smooth.positions.size());
    for (std::size_t v = 0; v < smooth.positions.size(); ++v)
        for (const Vec3& part : {smooth.positions[v], smooth.normals[v]})
            surface.insert(surface.end(), {part.x, part.y, part.z});
    Division(smooth, *this).write();
}

} // namespace scree::fibres
