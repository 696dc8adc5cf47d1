// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/flat_mesh.h"

namespace scree {

Mesh flat_mesh(const Region& region, std::string name, const Box2& uv_box) {
    const Vec2 size = uv_box.size();
    Mesh mesh;
    mesh.name = std::move(name);
    for (const Vec2& v : region.vertices) {
        mesh.positions.emplace_back(static_cast<float>(v.x), 0.0F, static_cast<float>(v.y));
        mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
        mesh.uvs.emplace_back(static_cast<float>((v.x - uv_box.min.x) / size.x),
                              static_cast<float>((uv_box.max.y - v.y) / size.y));
    }
    // Counter-clockwise in (x, z) is clockwise seen from above.
    for (const auto& t : region.triangles)
        mesh.triangles.push_back({t[0], t[2], t[1]});
    return mesh;
}

Mesh flat_mesh(const Region& region, std::string name) {
    return flat_mesh(region, std::move(name), bounds(region));
}

} // namespace scree
