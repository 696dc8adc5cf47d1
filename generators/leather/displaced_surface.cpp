// SPDX-License-Identifier: GPL-3.0-or-later
// The two shapes that are generated as grids: the flat swatch and the sphere.
#include "generators/leather/displaced_surface.h"

#include "core/parallel.h"

#include <algorithm>

namespace scree {

namespace {

/// A place on the undisplaced surface.
struct SurfacePoint {
    Vec3 position;
    Vec3 right; // direction of growing u, unit
    Vec3 out;   // normal, unit
    Vec3 down;  // direction of falling v, unit
    Vec2 uv;    // of the map
    float strength = 1;
};

/// Displaces a grid of (n + 1) x (n + 1) points, row 0 at the top; normals from the
/// differences of its points.
template <class Surface>
Mesh displaced_grid(const HeightField& field, std::size_t n, const Surface& surface) {
    const std::size_t side = n + 1;
    Mesh mesh;
    mesh.positions.resize(side * side);
    mesh.normals.resize(side * side);
    mesh.uvs.resize(side * side);
    mesh.triangles.resize(2 * n * n);
    parallel_for(side, 8, [&](std::size_t j) {
        for (std::size_t i = 0; i < side; ++i) {
            const SurfacePoint p = surface(double(i) / double(n), double(j) / double(n));
            const Vec3 offset = field.offset(p.uv) * p.strength;
            mesh.positions[j * side + i] =
                p.position + p.right * offset.x + p.out * offset.y + p.down * offset.z;
            mesh.normals[j * side + i] = p.out;
            mesh.uvs[j * side + i] = Vec2f(p.uv);
        }
    });
    parallel_for(side, 8, [&](std::size_t j) {
        const std::size_t up = j == 0 ? 0 : j - 1, down = std::min(j + 1, n);
        for (std::size_t i = 0; i < side; ++i) {
            const std::size_t left = i == 0 ? 0 : i - 1, right = std::min(i + 1, n);
            const Vec3 along = mesh.positions[j * side + right] - mesh.positions[j * side + left];
            const Vec3 across = mesh.positions[down * side + i] - mesh.positions[up * side + i];
            Vec3& normal = mesh.normals[j * side + i];
            const Vec3 found = across.cross(along).normalized();
            if (found.length2() > 0.5F) // otherwise a point where the grid has no area
                normal = found;
        }
    });
    parallel_for(n, 8, [&](std::size_t j) {
        for (std::size_t i = 0; i < n; ++i) {
            const auto a = static_cast<std::uint32_t>(j * side + i);
            const auto b = static_cast<std::uint32_t>(a + side); // below a
            // Diagonals point to the middle of the grid: where the sphere's grid has corners, the
            // other diagonal would cut them off.
            const bool falls = (i < n / 2) == (j < n / 2);
            mesh.triangles[2 * (j * n + i)] = {a, b, falls ? b + 1 : a + 1};
            mesh.triangles[2 * (j * n + i) + 1] = {falls ? a : b, b + 1, a + 1};
        }
    });
    return mesh;
}

std::size_t cells_per_side(std::size_t triangles) { // even
    return 2 * std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(double(triangles) / 8)));
}

/// The same where four walls of 2 n triangles are added to the 2 n^2 of the grid.
std::size_t cells_per_side_with_walls(std::size_t triangles) {
    const double n = std::sqrt(4 + double(triangles) / 2) - 2;
    return 2 * std::max<std::size_t>(1, static_cast<std::size_t>(n / 2));
}

/// Walls from the grid's border down to y = 0.
void add_cut_edges(Mesh& mesh, std::size_t n) {
    const std::size_t side = n + 1;
    const auto wall = [&](auto index,
                          const Vec3& normal) { // index(k), to the right seen from outside
        for (std::size_t k = 0; k <= n; ++k) {
            const std::size_t top = index(k);
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            const Vec3 p = mesh.positions[top];
            const Vec2f uv = mesh.uvs[top];
            for (const float y : {p.y, 0.0F}) {
                mesh.positions.emplace_back(p.x, y, p.z);
                mesh.normals.push_back(normal);
                mesh.uvs.push_back(uv);
            }
            if (k > 0) {
                mesh.triangles.push_back({first - 2, first - 1, first + 1});
                mesh.triangles.push_back({first - 2, first + 1, first});
            }
        }
    };
    wall([&](std::size_t k) { return n * side + k; }, Vec3(0, 0, 1));
    wall([&](std::size_t k) { return n - k; }, Vec3(0, 0, -1));
    wall([&](std::size_t k) { return (n - k) * side + n; }, Vec3(1, 0, 0));
    wall([&](std::size_t k) { return k * side; }, Vec3(-1, 0, 0));
}

} // namespace

Mesh displaced_swatch(const HeightField& field, double thickness, std::size_t triangles) {
    const std::size_t n =
        thickness > 0 ? cells_per_side_with_walls(triangles) : cells_per_side(triangles);
    Mesh mesh = displaced_grid(field, n, [&](double across, double down) {
        SurfacePoint p;
        p.uv = {across, 1 - down};
        p.position =
            Vec3(static_cast<float>(field.size.x * (across - 0.5)), static_cast<float>(thickness),
                 static_cast<float>(field.size.y * (down - 0.5)));
        p.right = {1, 0, 0};
        p.out = {0, 1, 0};
        p.down = {0, 0, 1};
        return p;
    });
    if (thickness > 0)
        add_cut_edges(mesh, n);
    mesh.name = "swatch";
    return mesh;
}

Mesh displaced_sphere(const HeightField& field, const Vec3& centre, double radius,
                      const Vec3& facing, std::size_t triangles) {
    using Imath::V3d;
    const V3d front = V3d(facing).normalized();
    const V3d above = std::abs(front.y) < 0.99 ? V3d(0, 1, 0) : V3d(0, 0, -1);
    const V3d right = above.cross(front).normalized();
    const V3d up = front.cross(right);
    Mesh mesh = displaced_grid(field, cells_per_side(triangles), [&](double across, double down) {
        // The square to the disk without changing areas (Shirley & Chiu 1997), the disk to the
        // sphere likewise (Lambert): all triangles have about the same size.
        const double a = 2 * across - 1, b = 1 - 2 * down;
        double r = 0, phi = 0;
        if (std::abs(a) > std::abs(b)) {
            r = a;
            phi = pi / 4 * b / a;
        } else if (b != 0) {
            r = b;
            phi = pi / 2 - pi / 4 * a / b;
        }
        if (r < 0) {
            r = -r;
            phi += pi;
        }
        const double theta = 2 * std::asin(std::min(1.0, r));
        const V3d radial = right * std::cos(phi) + up * std::sin(phi);
        const V3d out = front * std::cos(theta) + radial * std::sin(theta);
        const V3d away = radial * std::cos(theta) - front * std::sin(theta);
        const V3d round = up * std::cos(phi) - right * std::sin(phi);
        SurfacePoint p;
        p.position = centre + Vec3(out * radius);
        p.out = Vec3(out);
        p.right = Vec3(away * std::cos(phi) - round * std::sin(phi));
        p.down = Vec3(away * -std::sin(phi) - round * std::cos(phi));
        const double reach = 2 * radius * r;
        p.uv = Vec2(0.5 + reach * std::cos(phi) / field.size.x,
                    0.5 + reach * std::sin(phi) / field.size.y);
        const double t = std::clamp((1 - r) / 0.03, 0.0, 1.0); // the last 28 degrees
        p.strength = static_cast<float>(t * t * (3 - 2 * t));
        return p;
    });
    mesh.name = "sphere";
    return mesh;
}

bool is_sphere(const Mesh& mesh, Vec3& centre, double& radius) {
    const Box3 box = bounds(mesh);
    const Vec3 size = box.size();
    centre = box.center();
    radius = std::max({size.x, size.y, size.z}) / 2;
    const double tolerance = 1e-4 * radius;
    // Few points lie on a sphere by accident, as a box's corners do.
    return mesh.positions.size() > 24 &&
           std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const Vec3& p) {
               return std::abs(double((p - centre).length()) - radius) < tolerance;
           });
}

} // namespace scree
