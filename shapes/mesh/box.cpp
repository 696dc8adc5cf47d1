// SPDX-License-Identifier: GPL-3.0-or-later
// mesh.plane, mesh.box and mesh.block.
#include "shapes/mesh/component.h"
#include "shapes/mesh/rounded_box.h"

#include <algorithm>

namespace scree {

namespace {

Mesh plane(const Params& params) {
    const double width = params.number("size");
    const double depth = number_or(params, "depth", width);
    const auto n = static_cast<std::uint32_t>(params.integer("segments"));
    Mesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i) {
            const Vec2f uv(static_cast<float>(i) / static_cast<float>(n),
                           static_cast<float>(j) / static_cast<float>(n));
            mesh.positions.emplace_back(static_cast<float>(width) * (uv.x - 0.5F), 0.0F,
                                        static_cast<float>(depth) * (0.5F - uv.y));
            mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
            mesh.uvs.push_back(uv);
        }
    }
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i;
            mesh.triangles.push_back({a, a + 1, a + n + 2});
            mesh.triangles.push_back({a, a + n + 2, a + n + 1});
        }
    return mesh;
}

// Shrinks the UVs of the sides of a rounded box, which fill the square, to one scale.
void lay_evenly(Mesh& mesh, const Imath::V3d& sides) {
    const double longest = std::max({sides.x, sides.y, sides.z});
    const std::size_t per_face = mesh.uvs.size() / 6;
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i) {
        const auto normal_axis = static_cast<int>(i / per_face / 2);
        Vec2f& uv = mesh.uvs[i];
        uv.x = static_cast<float>(uv.x * sides[(normal_axis + 1) % 3] / longest);
        uv.y = static_cast<float>(uv.y * sides[(normal_axis + 2) % 3] / longest);
    }
}

Mesh box(const Params& params) {
    const double width = params.number("width");
    const double height = number_or(params, "height", width);
    const double depth = number_or(params, "depth", width);
    const double shortest = std::min({width, height, depth});
    Mesh mesh = rounded_box(Vec3(Imath::V3d(width, height, depth)),
                            params.number("rounding") * shortest / 2);
    if (params.text("uvs") == "even")
        lay_evenly(mesh, {width, height, depth});
    return mesh;
}

// A wooden toy cube with rounded edges and a shallow recessed panel on every face.
Mesh block(const Params& params) {
    const double size = params.number("size");
    const double depth = params.number("panel") * size;
    if (depth <= 0)
        return rounded_box(Vec3(static_cast<float>(size)), 0.07 * size);
    const double rim = 0.78; // the panel slopes from `rim` to `floor`, shares of the flat face
    const double floor = 0.72;
    Mesh mesh = rounded_box(Vec3(static_cast<float>(size)), 0.07 * size, {-rim, -floor, floor, rim},
                            [&](double u, double v) {
                                return std::max(std::abs(u), std::abs(v)) <= floor ? depth : 0.0;
                            });
    compute_normals(mesh, radians(30), NormalWeight::angle_and_area);
    return mesh;
}

} // namespace

Plugin<MakeMesh> plane_component() {
    return component("plane", "A flat rectangle in the x-z plane, facing up.",
                     {metres("size", "Width along x; also the depth unless that is given.", 1.0),
                      optional_metres("depth", "Depth along z; the same as size by default."),
                      count("segments", "Cells along each side.", 1, 1, 1000)},
                     plane);
}

Plugin<MakeMesh> box_component() {
    return component(
        "box", "A box with rounded edges.",
        {metres("width", "Side along x; also of the others unless given.", 0.1),
         optional_metres("height", "Side along y; the same as width by default."),
         optional_metres("depth", "Side along z; the same as width by default."),
         ratio("rounding", "Radius of the edges as a share of half the shortest side; 0: sharp.",
               0.06, 0, 0.95),
         {.name = "uvs",
          .type = ParamType::choice,
          .doc =
              "sides: a texture fills each side, stretched to its form; even: it has one scale on "
              "all sides and fills a square as wide as the longest.",
          .fallback = std::string("sides"),
          .choices = {"sides", "even"}}},
        box);
}

Plugin<MakeMesh> block_component() {
    return component(
        "block", "A toy cube with soft edges and a sunk panel on every face.",
        {metres("size", "Side of the cube.", 0.045),
         ratio("panel", "Depth of the panels as a share of the side; 0: none.", 0.025, 0, 0.05)},
        block);
}

} // namespace scree
