// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/field.h"
#include "shapes/mesh/component.h"

#include <fmt/format.h>

namespace scree {

namespace {

constexpr double most_rows = 4096;

Mesh terrain(const Params& params) {
    const std::shared_ptr<const Field> height = field_of(params, "height");
    const Vec2 size(params.number("width"), params.number("depth"));
    const auto columns = static_cast<std::uint32_t>(params.integer("columns"));
    const double wanted = std::max(1.0, std::round(double(columns) * size.y / size.x));
    if (wanted > most_rows)
        throw params.error(
            "depth", fmt::format("gives {:.3g} rows of squares as wide as a column", wanted),
            fmt::format("expected at most {:.0f}: fewer columns, or a width more like "
                        "the depth",
                        most_rows));
    const auto rows = static_cast<std::uint32_t>(wanted);
    Mesh mesh;
    for (std::uint32_t j = 0; j <= rows; ++j)
        for (std::uint32_t i = 0; i <= columns; ++i) {
            const Vec2f uv(float(i) / float(columns), 1 - float(j) / float(rows));
            const Vec2 at((double(uv.x) - 0.5) * size.x, (0.5 - double(uv.y)) * size.y);
            const double y = height->at(at);
            if (!std::isfinite(y) || std::abs(y) > 1e6)
                throw params.error("height", "is not a height in metres everywhere");
            mesh.positions.emplace_back(WideVec3(at.x, y, at.y));
            mesh.uvs.push_back(uv);
        }
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t far = j * (columns + 1) + i; // -z of the cell, and near its +z
            const std::uint32_t near = far + columns + 1;
            mesh.triangles.push_back({far, near, near + 1});
            mesh.triangles.push_back({far, near + 1, far + 1});
        }
    compute_normals(mesh, pi);
    return mesh;
}

} // namespace

Plugin<MakeMesh> terrain_component() {
    // Not laid down like other components: the field's heights and places are those of the scene.
    return {"terrain",
            "Ground whose height is a field: an open surface about the origin.",
            {{.name = "height",
              .type = ParamType::field,
              .doc = "Height by place, in metres.",
              .fallback = 0.0},
             metres("width", "Along x.", 10),
             metres("depth", "Along z.", 10),
             count("columns", "Squares along x, of two triangles each.", 100, 1, 1024)},
            [](const Params& params) {
                Mesh mesh = terrain(params);
                mesh.name = "terrain";
                return mesh;
            }};
}

} // namespace scree
