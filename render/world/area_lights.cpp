// SPDX-License-Identifier: GPL-3.0-or-later
// Area lights in the world: one geometry of two triangles for each.
#include "render/world/world_state.h"

#include <algorithm>

namespace scree {

void World::State::add_area_lights() {
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (const auto* area = std::get_if<AreaLight>(&lights[i])) {
            for (const Vec3& p : area->corners()) // moved to the origin
                light_vertices.push_back(p);
            light_of_quad.push_back(static_cast<std::uint32_t>(i));
        }
    if (light_of_quad.empty())
        return;
    const embree::GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    void* positions =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Vec3), light_vertices.size());
    void* triples =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(Mesh::Triangle), 2 * light_of_quad.size());
    check();
    std::copy(light_vertices.begin(), light_vertices.end(), static_cast<Vec3*>(positions));
    auto* triangle = static_cast<Mesh::Triangle*>(triples);
    for (std::uint32_t quad = 0; quad < light_of_quad.size(); ++quad) {
        *triangle++ = {4 * quad, 4 * quad + 1, 4 * quad + 2};
        *triangle++ = {4 * quad, 4 * quad + 2, 4 * quad + 3};
    }
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene.get(), geometry.get(), static_cast<unsigned>(instances.size()));
}

void World::State::fill_light(const RawHit& found, Hit& hit) const {
    const std::size_t quad = found.primitive / 2;
    const Vec3& corner = light_vertices[4 * quad];
    const Vec3 u = light_vertices[4 * quad + 1] - corner;
    const Vec3 v = light_vertices[4 * quad + 3] - corner;
    hit.normal = hit.shading_normal = u.cross(v).normalized();
    hit.random = 0;
    hit.instance = Hit::none;
    hit.material = 0;
    hit.light = light_of_quad[quad];
    hit.smooth = false;
    hit.uv = {0.0F, 0.0F};
    hit.uv_per_metre = 0;
    hit.tangent = Vec3(0.0F);
    hit.record = nullptr;
}

} // namespace scree
