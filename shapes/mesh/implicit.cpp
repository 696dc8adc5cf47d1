// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/implicit.h"

#include <algorithm>
#include <limits>
#include <map>

namespace scree {

namespace {

Vec3d gradient(const SignedField& field, const Vec3d& p, double step) {
    Vec3d out;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3d offset(0.0);
        offset[axis] = step;
        out[axis] = (field(p + offset) - field(p - offset)) / (2 * step);
    }
    return out;
}

// Field values on the corners of a grid of cubic cells.
struct Grid {
    Vec3d origin;
    double cell;
    std::array<int, 3> size; // corners per axis
    std::vector<float> values;

    Grid(const SignedField& field, const Imath::Box3d& box, double side)
        : origin(box.min), cell(side) {
        for (int axis = 0; axis < 3; ++axis)
            size[axis] = int(std::ceil((box.max[axis] - box.min[axis]) / side)) + 1;
        values.reserve(std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]));
        for (int z = 0; z < size[2]; ++z)
            for (int y = 0; y < size[1]; ++y)
                for (int x = 0; x < size[0]; ++x)
                    values.push_back(static_cast<float>(field(point(x, y, z))));
    }
    Vec3d point(int x, int y, int z) const { return origin + Vec3d(x, y, z) * cell; }
    std::size_t index(int x, int y, int z) const {
        return (std::size_t(z) * std::size_t(size[1]) + std::size_t(y)) * std::size_t(size[0]) +
               std::size_t(x);
    }
    float at(int x, int y, int z) const { return values[index(x, y, z)]; }
};

// Sets `out` to the mean of the zero crossings on the cell's edges; false when there are none.
bool cell_vertex(const Grid& grid, int x, int y, int z, Vec3d& out) {
    Vec3d sum(0.0);
    int crossings = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 4; ++side) {
            std::array<int, 3> from{x, y, z};
            from[(axis + 1) % 3] += side & 1;
            from[(axis + 2) % 3] += side >> 1;
            std::array<int, 3> to = from;
            ++to[axis];
            const double a = double(grid.at(from[0], from[1], from[2]));
            const double b = double(grid.at(to[0], to[1], to[2]));
            if ((a < 0) == (b < 0))
                continue;
            Vec3d p = grid.point(from[0], from[1], from[2]);
            p[axis] += grid.cell * a / (a - b);
            sum += p;
            ++crossings;
        }
    }
    if (crossings > 0)
        out = sum / crossings;
    return crossings > 0;
}

Mesh surface_net(const Grid& grid) {
    Mesh mesh;
    std::vector<std::uint32_t> vertex(grid.values.size(), 0);
    for (int z = 0; z + 1 < grid.size[2]; ++z)
        for (int y = 0; y + 1 < grid.size[1]; ++y)
            for (int x = 0; x + 1 < grid.size[0]; ++x) {
                Vec3d p;
                if (!cell_vertex(grid, x, y, z, p))
                    continue;
                vertex[grid.index(x, y, z)] = static_cast<std::uint32_t>(mesh.positions.size());
                mesh.positions.emplace_back(p);
            }
    // One quad around every grid edge that crosses the surface.
    for (int z = 1; z + 1 < grid.size[2]; ++z)
        for (int y = 1; y + 1 < grid.size[1]; ++y)
            for (int x = 1; x + 1 < grid.size[0]; ++x)
                for (int axis = 0; axis < 3; ++axis) {
                    std::array<int, 3> to{x, y, z};
                    ++to[axis];
                    const bool inside = grid.at(x, y, z) < 0;
                    if (inside == (grid.at(to[0], to[1], to[2]) < 0))
                        continue;
                    std::array<std::uint32_t, 4> quad{};
                    for (int k = 0; k < 4; ++k) { // the cells around the edge, right-handed
                        std::array<int, 3> cell{x, y, z};
                        cell[(axis + 1) % 3] -= k == 0 || k == 3 ? 1 : 0;
                        cell[(axis + 2) % 3] -= k < 2 ? 1 : 0;
                        quad[k] = vertex[grid.index(cell[0], cell[1], cell[2])];
                    }
                    if (!inside)
                        std::swap(quad[1], quad[3]);
                    const auto diagonal = [&](int a, int b) {
                        return (mesh.positions[quad[a]] - mesh.positions[quad[b]]).length2();
                    };
                    const int first = diagonal(0, 2) <= diagonal(1, 3) ? 0 : 1;
                    mesh.triangles.push_back({quad[first], quad[first + 1], quad[(first + 2) % 4]});
                    mesh.triangles.push_back(
                        {quad[first], quad[(first + 2) % 4], quad[(first + 3) % 4]});
                }
    return mesh;
}

// u is the angle about the y axis, v the height; vertices on the seam are duplicated.
void add_polar_uvs(Mesh& mesh) {
    const Box3 box = bounds(mesh);
    for (const Vec3& p : mesh.positions)
        mesh.uvs.emplace_back(
            std::atan2(-p.z, p.x) / static_cast<float>(2 * pi) + 0.5F,
            (p.y - box.min.y) / std::max(box.max.y - box.min.y, std::numeric_limits<float>::min()));
    std::map<std::uint32_t, std::uint32_t> repeated;
    for (Mesh::Triangle& t : mesh.triangles) {
        float highest = 0;
        for (const std::uint32_t i : t)
            highest = std::max(highest, mesh.uvs[i].x);
        for (std::uint32_t& i : t) {
            if (mesh.uvs[i].x > highest - 0.5F)
                continue;
            const auto [copy, fresh] =
                repeated.try_emplace(i, static_cast<std::uint32_t>(mesh.positions.size()));
            if (fresh) {
                mesh.positions.push_back(Vec3(mesh.positions[i]));
                mesh.normals.push_back(Vec3(mesh.normals[i]));
                mesh.uvs.push_back(mesh.uvs[i] + Vec2f(1, 0));
            }
            i = copy->second;
        }
    }
}

} // namespace

Mesh polygonise(const SignedField& field, const Imath::Box3d& box, double cell) {
    // Where the surface passes twice through one cell, the mesh has a non-manifold edge (of four
    // faces). A slightly shifted grid avoids that.
    Mesh mesh;
    for (int attempt = 0; attempt < 12; ++attempt) {
        const double shift = 0.37 * cell * (attempt % 4);
        const double side = cell * (1 - 0.07 * attempt);
        mesh = surface_net(Grid(field, {box.min - Vec3d(shift), box.max}, side));
        if (inspect(mesh).closed())
            break;
    }
    const double step = 0.05 * cell;
    for (Vec3& position : mesh.positions) {
        Vec3d p(position);
        for (int i = 0; i < 3; ++i) {
            const Vec3d slope = gradient(field, p, step);
            const Vec3d move = slope * (-field(p) / std::max(slope.length2(), 1e-6));
            // Steps are limited, since vertices that move far could pass one another.
            p += move * std::min(1.0, 0.25 * cell / std::max(move.length(), 1e-12));
        }
        position = Vec3(p);
        mesh.normals.emplace_back(gradient(field, p, step).normalized());
    }
    add_polar_uvs(mesh);
    return mesh;
}

double smooth_union(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - h * h * k / 4;
}

double capsule(const Vec3d& p, const Vec3d& a, const Vec3d& b, double radius) {
    const Vec3d axis = b - a;
    const double t = std::clamp((p - a).dot(axis) / axis.length2(), 0.0, 1.0);
    return (p - a - axis * t).length() - radius;
}

double ellipsoid(const Vec3d& p, const Vec3d& center, const Vec3d& half_axes) {
    const Vec3d q = p - center;
    const double k0 = (q / half_axes).length();
    const double k1 = (q / (half_axes * half_axes)).length();
    return k1 > 1e-9 ? k0 * (k0 - 1) / k1 : -std::min({half_axes.x, half_axes.y, half_axes.z});
}

} // namespace scree
