// SPDX-License-Identifier: GPL-3.0-or-later
// mesh.cut_sphere: a ball with a wedge or an octant cut out, so that its inside is visible.
#include "shapes/mesh/component.h"

#include <algorithm>

namespace scree {

namespace {

struct Cut {
    double radius;
    double angle; // of the wedge, which is symmetric about +z
    double floor; // height of the wedge's floor above the centre; -radius: no floor
};

// Adds a strip between two rows of `columns` + 1 vertices. Its triangles are counter-clockwise when
// `upper` lies to the left of `lower`. Degenerate triangles are left out.
void add_strip(Mesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t columns) {
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const std::vector<Vec3>& p = mesh.positions;
        if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a])
            mesh.triangles.push_back({a, b, c});
    };
    for (std::uint32_t i = 0; i < columns; ++i) {
        add(lower + i, lower + i + 1, upper + i + 1);
        add(lower + i, upper + i + 1, upper + i);
    }
}

// (radius, height) of circles of latitude. The poles have exactly radius 0.
std::vector<Vec2> latitudes(double radius, double from, double to, int steps) {
    std::vector<Vec2> out;
    for (int k = 0; k <= steps; ++k) {
        const double angle = from + (to - from) * k / steps;
        const double width = std::abs(angle) == pi / 2 ? 0 : radius * std::cos(angle);
        out.emplace_back(width, radius * std::sin(angle));
    }
    return out;
}

// The surface of the ball; `angles` are measured about the y axis from +z towards +x.
void add_skin(Mesh& mesh, const std::vector<Vec2>& rows, const std::vector<double>& angles,
              double radius) {
    const auto columns = static_cast<std::uint32_t>(angles.size() - 1);
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        for (const double angle : angles) {
            const Imath::V3d p(rows[j].x * std::sin(angle), rows[j].y, rows[j].x * std::cos(angle));
            mesh.positions.emplace_back(p);
            mesh.normals.emplace_back(p / radius);
            mesh.uvs.emplace_back(static_cast<float>(angle / (2 * pi)),
                                  static_cast<float>(0.5 + std::asin(p.y / radius) / pi));
        }
        if (j > 0)
            add_strip(mesh, base - columns - 1, base, columns);
    }
}

Vec2f flat_uv(double x, double y, double radius) {
    return {static_cast<float>(0.5 + 0.5 * x / radius), static_cast<float>(0.5 + 0.5 * y / radius)};
}

// The half disc between the axis and the ball's surface at `angle`, facing into the wedge.
void add_wall(Mesh& mesh, const std::vector<Vec2>& rows, double angle, double radius) {
    const double side = angle > 0 ? 1 : -1; // right or left of the wedge, seen from +z
    const Imath::V3d normal(-side * std::cos(angle), 0, side * std::sin(angle));
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        const double width = rows[j].x;
        // From left to right as seen from inside the wedge.
        for (const double x : {side > 0 ? 0.0 : width, side > 0 ? width : 0.0}) {
            mesh.positions.emplace_back(
                Imath::V3d(x * std::sin(angle), rows[j].y, x * std::cos(angle)));
            mesh.normals.emplace_back(normal);
            mesh.uvs.push_back(flat_uv(side * x, rows[j].y, radius));
        }
        if (j > 0)
            add_strip(mesh, base - 2, base, 1);
    }
}

// The circular sector that forms the floor of the wedge.
void add_floor(Mesh& mesh, const Vec2& rim, const std::vector<double>& angles, double radius) {
    const auto center = static_cast<std::uint32_t>(mesh.positions.size());
    const auto add = [&](double x, double z) {
        mesh.positions.emplace_back(Imath::V3d(x, rim.y, z));
        mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
        mesh.uvs.push_back(flat_uv(x, -z, radius));
    };
    add(0, 0);
    for (const double angle : angles)
        add(rim.x * std::sin(angle), rim.x * std::cos(angle));
    for (std::uint32_t i = 1; i < angles.size(); ++i)
        mesh.triangles.push_back({center, center + i, center + i + 1});
}

std::vector<double> even_angles(double from, double to, int segments) {
    std::vector<double> angles;
    for (int i = 0; i <= segments; ++i)
        angles.push_back(i == segments ? to : from + (to - from) * i / segments);
    return angles;
}

Mesh cut_sphere(const Params& params) {
    const Cut cut{params.number("radius"), params.number("angle"),
                  params.number("floor") * params.number("radius")};
    const auto segments = static_cast<int>(params.integer("segments"));
    const double open = cut.angle / (2 * pi);
    const int open_segments = std::max(1, int(std::lround(open * segments)));
    const std::vector<double> inner = even_angles(-cut.angle / 2, cut.angle / 2, open_segments);
    std::vector<double> outer =
        even_angles(cut.angle / 2, 2 * pi - cut.angle / 2, std::max(1, segments - open_segments));
    const double latitude = std::asin(std::clamp(params.number("floor"), -1.0, 1.0));
    const auto steps_of = [&](double share) {
        return std::max(2, int(std::lround(share / pi * segments / 2)));
    };
    const std::vector<Vec2> upper =
        latitudes(cut.radius, latitude, pi / 2, steps_of(pi / 2 - latitude));

    Mesh mesh;
    add_skin(mesh, upper, outer, cut.radius);
    add_wall(mesh, upper, cut.angle / 2, cut.radius);
    add_wall(mesh, upper, -cut.angle / 2, cut.radius);
    if (upper.front().x > 0) {
        const std::vector<Vec2> lower =
            latitudes(cut.radius, -pi / 2, latitude, steps_of(latitude + pi / 2));
        add_skin(mesh, lower, outer, cut.radius);
        add_skin(mesh, lower, inner, cut.radius);
        add_floor(mesh, upper.front(), inner, cut.radius);
    }
    return mesh;
}

} // namespace

Plugin<MakeMesh> cut_sphere_component() {
    return component(
        "cut_sphere", "A ball with a piece taken out, open towards +z, so that its inside shows.",
        {metres("radius", "Radius of the ball.", 0.05),
         angle_degrees("angle", "Angle of the piece about the y axis.", 90, 5, 355),
         ratio("floor",
               "Height at which the cut ends as a share of the radius: 0 takes out an octant at "
               "90 degrees, -1 a wedge from pole to pole.",
               0, -1, 0.9),
         count("segments", "Segments around the ball.", 96, 12, 1024)},
        cut_sphere);
}

} // namespace scree
