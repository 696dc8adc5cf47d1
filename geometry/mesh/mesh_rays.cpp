// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_rays.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

} // namespace

MeshRays::MeshRays(const Mesh& mesh) : mesh_(&mesh) {
    const Box3 box = bounds(mesh);
    const double longest = double(box.size()[int(box.majorAxis())]);
    const Vec3d margin(1e-4 * longest);
    box_ = {Vec3d(box.min) - margin, Vec3d(box.max) + margin};
    // The surface crosses about as many cells as it has triangles.
    const double per_side = std::clamp(std::sqrt(double(mesh.triangles.size()) / 4), 1.0, 256.0);
    for (int axis = 0; axis < 3; ++axis) {
        const double size = box_.size()[axis];
        count_[std::size_t(axis)] =
            std::max(1, static_cast<int>(size / (longest * 1.0002) * per_side));
        side_[axis] = size / count_[std::size_t(axis)];
    }
    const auto each_cell = [&](const Mesh::Triangle& t, const auto& body) {
        Imath::Box3d around;
        for (const std::uint32_t v : t)
            around.extendBy(Vec3d(mesh.positions[v]));
        std::array<int, 3> low{}, high{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto cell = [&](double x) {
                return std::clamp(static_cast<int>((x - box_.min[axis]) / side_[axis]), 0,
                                  count_[std::size_t(axis)] - 1);
            };
            low[std::size_t(axis)] = cell(around.min[axis] - margin.x);
            high[std::size_t(axis)] = cell(around.max[axis] + margin.x);
        }
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int x = low[0]; x <= high[0]; ++x)
                    body(std::size_t((z * count_[1] + y) * count_[0] + x));
    };
    first_.assign(std::size_t(count_[0]) * std::size_t(count_[1]) * std::size_t(count_[2]) + 1, 0);
    for (const Mesh::Triangle& t : mesh.triangles)
        each_cell(t, [&](std::size_t cell) { ++first_[cell + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    triangles_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        each_cell(mesh.triangles[i], [&](std::size_t cell) { triangles_[next[cell]++] = i; });
}

bool MeshRays::hits(const Vec3d& origin, const Vec3& direction, double from) const {
    const Vec3d d(direction);
    double enter = from;
    double leave = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis) {
        if (d[axis] == 0) {
            if (origin[axis] < box_.min[axis] || origin[axis] > box_.max[axis])
                return false;
            continue;
        }
        const double a = (box_.min[axis] - origin[axis]) / d[axis];
        const double b = (box_.max[axis] - origin[axis]) / d[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (enter > leave)
        return false;
    const Vec3d start = origin + d * enter;
    std::array<int, 3> cell{}, step{};
    Vec3d next, each;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = std::size_t(axis);
        cell[a] = std::clamp(static_cast<int>((start[axis] - box_.min[axis]) / side_[axis]), 0,
                             count_[a] - 1);
        step[a] = d[axis] < 0 ? -1 : 1;
        if (d[axis] == 0) {
            next[axis] = each[axis] = std::numeric_limits<double>::max();
            continue;
        }
        const double border = box_.min[axis] + (cell[a] + (step[a] > 0 ? 1 : 0)) * side_[axis];
        next[axis] = (border - origin[axis]) / d[axis];
        each[axis] = side_[axis] / std::abs(d[axis]);
    }
    for (;;) {
        const auto at = std::size_t((cell[2] * count_[1] + cell[1]) * count_[0] + cell[0]);
        for (std::uint32_t i = first_[at]; i < first_[at + 1]; ++i)
            if (hits_triangle(triangles_[i], origin, d, from))
                return true;
        const int axis = next.x <= next.y && next.x <= next.z ? 0 : next.y <= next.z ? 1 : 2;
        const auto a = std::size_t(axis);
        cell[a] += step[a];
        if (cell[a] < 0 || cell[a] >= count_[a])
            return false;
        next[axis] += each[axis];
    }
}

// Moeller & Trumbore 1997.
bool MeshRays::hits_triangle(std::uint32_t t, const Vec3d& origin, const Vec3d& direction,
                             double from) const {
    const Mesh::Triangle& v = mesh_->triangles[t];
    const Vec3d a(mesh_->positions[v[0]]);
    const Vec3d ab = Vec3d(mesh_->positions[v[1]]) - a;
    const Vec3d ac = Vec3d(mesh_->positions[v[2]]) - a;
    const Vec3d p = direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0)
        return false;
    const Vec3d to = origin - a;
    const double u = to.dot(p) / determinant;
    const Vec3d q = to.cross(ab);
    const double w = direction.dot(q) / determinant;
    return u >= 0 && w >= 0 && u + w <= 1 && ac.dot(q) / determinant > from;
}

} // namespace scree
