// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/extrude.h"

#include "geometry/plane/region_tools.h"
#include "shapes/mesh/loft.h"
#include "shapes/mesh/outline.h"

#include "core/error.h"

#include <algorithm>

namespace scree {

namespace {

constexpr double extrusion_crease = radians(30);

Vec3 raise(const Vec2& p, double y) {
    return {static_cast<float>(p.x), static_cast<float>(y), static_cast<float>(-p.y)};
}

SpaceRing raise(const Ring& ring, double y) {
    SpaceRing out;
    for (const Vec2& p : ring)
        out.push_back(raise(p, y));
    return out;
}

// The rounded wall of one ring, from the edge of the lower cap to that of the upper cap.
Mesh wall(const Ring& ring, double height, double bevel, int bevel_segments) {
    std::vector<SpaceRing> levels;
    for (int k = 0; k <= bevel_segments && bevel > 0; ++k) {
        const double angle = pi / 2 * k / bevel_segments;
        const double in = k == bevel_segments ? 0 : bevel * (1 - std::sin(angle));
        levels.push_back(raise(inset(ring, in), bevel * (1 - std::cos(angle))));
    }
    if (bevel <= 0)
        levels.push_back(raise(ring, 0));
    for (std::size_t k = levels.size(); k-- > 0;) {
        SpaceRing mirrored = levels[k];
        for (Vec3& p : mirrored)
            p.y = static_cast<float>(height - double(p.y));
        if (mirrored.front().y > levels.back().front().y)
            levels.push_back(std::move(mirrored));
    }
    return loft(levels);
}

void add_cap(Mesh& mesh, const Region& plan, const Box2& frame, double y, bool upwards) {
    Mesh cap;
    const Vec2 size = frame.size();
    for (const Vec2& p : plan.vertices) {
        cap.positions.push_back(raise(p, y));
        cap.uvs.emplace_back(static_cast<float>((p.x - frame.min.x) / size.x),
                             static_cast<float>((p.y - frame.min.y) / size.y));
    }
    cap.triangles = plan.triangles;
    if (!upwards)
        for (Mesh::Triangle& t : cap.triangles)
            std::swap(t[1], t[2]);
    append(mesh, cap);
}

// Sets the normals of the caps exactly: averaged normals are inaccurate where long thin cap
// triangles have a small angle.
void flatten_cap_normals(Mesh& mesh, float top) {
    const auto limit = static_cast<float>(std::cos(extrusion_crease));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const float y = mesh.positions[i].y;
        Vec3& normal = mesh.normals[i];
        if ((y == 0.0F || y == top) && std::abs(normal.y) > limit)
            normal = Vec3(0, normal.y > 0 ? 1.0F : -1.0F, 0);
    }
}

// The plan of a cap. Reduces `bevel` where the body is narrower than two bevels, since the cap's
// outline would otherwise cross itself.
Region cap_plan(const std::vector<Ring>& rings, double height, double& bevel) {
    while (true) {
        std::vector<Ring> caps;
        for (const Ring& ring : rings)
            caps.push_back(inset(ring, bevel));
        try {
            return triangulate(std::move(caps));
        } catch (const Error&) {
            if (bevel == 0)
                throw;
            bevel = bevel > 0.01 * height ? bevel / 2 : 0;
        }
    }
}

} // namespace

Mesh extrude(const std::vector<Ring>& rings, double height, double bevel, int bevel_segments) {
    bevel = std::min(bevel, 0.45 * height);
    for (const Ring& ring : rings)
        bevel = std::min(bevel, 0.8 * largest_inset(ring));

    const Region plan = cap_plan(rings, height, bevel);
    Mesh mesh;
    Box2 frame;
    for (const Ring& ring : rings) {
        append(mesh, wall(ring, height, bevel, bevel_segments));
        for (const Vec2& p : ring)
            frame.extendBy(p);
    }
    add_cap(mesh, plan, frame, height, true);
    add_cap(mesh, plan, frame, 0, false);
    compute_normals(mesh, extrusion_crease, NormalWeight::angle_and_area);
    flatten_cap_normals(mesh, static_cast<float>(height));
    return mesh;
}

} // namespace scree
