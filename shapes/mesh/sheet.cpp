// SPDX-License-Identifier: GPL-3.0-or-later
// mesh.sheet: leaves, petals and paper, cut out along an outline and bent.
#include "geometry/plane/region_tools.h"
#include "shapes/mesh/component.h"
#include "shapes/mesh/outline.h"

#include <algorithm>
#include <map>

namespace scree {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// A pointed leaf, `length` long.
Region leaf(double length) {
    // Two arcs that meet at a right angle.
    const double radius = length * std::sqrt(0.5);
    Ring outline = arc({0, length / 2}, radius, -0.75 * pi, -0.25 * pi, 24);
    const Ring back = arc({0, -length / 2}, radius, 0.25 * pi, 0.75 * pi, 24);
    outline.insert(outline.end(), back.begin() + 1, back.end() - 1);
    return triangulate({outline});
}

/// Bisects edges longer than `longest` until there are none. In each pass a triangle with one, two
/// or three such edges is split into two, three or four.
void refine(Region& region, double longest) {
    for (;;) {
        std::map<Edge, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) -> const std::uint32_t* {
            const auto found = middles.find(edge_of(a, b));
            return found == middles.end() ? nullptr : &found->second;
        };
        for (const auto& t : region.triangles) {
            for (unsigned k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                if (middle(a, b) != nullptr ||
                    (region.vertices[a] - region.vertices[b]).length() <= longest)
                    continue;
                middles[edge_of(a, b)] = static_cast<std::uint32_t>(region.vertices.size());
                region.vertices.push_back((region.vertices[a] + region.vertices[b]) / 2);
            }
        }
        if (middles.empty())
            return;
        std::vector<std::array<std::uint32_t, 3>> cut;
        for (const auto& t : region.triangles) {
            // The triangle's corners and edge midpoints in order.
            std::vector<std::uint32_t> ring;
            for (unsigned k = 0; k < 3; ++k) {
                ring.push_back(t[k]);
                if (const std::uint32_t* m = middle(t[k], t[(k + 1) % 3]))
                    ring.push_back(*m);
            }
            if (ring.size() == 6) {
                for (unsigned k = 1; k < 6; k += 2)
                    cut.push_back({ring[k], ring[k + 1 == 6 ? 0 : k + 1], ring[(k + 2) % 6]});
                cut.push_back({ring[1], ring[3], ring[5]});
                continue;
            }
            // A fan from a midpoint has no degenerate triangle.
            while (std::find(t.begin(), t.end(), ring[0]) != t.end() && ring.size() > 3)
                std::rotate(ring.begin(), ring.begin() + 1, ring.end());
            for (std::size_t k = 1; k + 1 < ring.size(); ++k)
                cut.push_back({ring[0], ring[k], ring[k + 1]});
        }
        region.triangles = std::move(cut);
    }
}

/// Bends an axis upwards into an arc: the new coordinate along the axis and the height of the point
/// that was `at`.
Vec2 bent(double at, double curvature) {
    const double turn = at * curvature;
    return std::abs(turn) < 1e-6 ? Vec2(at, 0.0)
                                 : Vec2(std::sin(turn), 1 - std::cos(turn)) / curvature;
}

Mesh sheet(const Params& params) {
    Region region = params.has("outline") ? *params.object<Region>("outline") : leaf(0.08);
    if (!(area(region) > 0))
        throw params.error("outline", "the region has no area");
    const Box2 box = bounds(region);
    const Vec2 size = box.size();
    const double longest = std::max(size.x, size.y);
    const double thickness = number_or(params, "thickness", 0.004 * longest);
    const double curl = params.number("curl") / size.x;
    const double cup = params.number("cup") / size.y;
    const double twist = params.number("twist") / size.x;
    refine(region, longest / 24);

    Mesh mesh;
    for (const double side : {1.0, 0.0}) { // above, below
        for (const Vec2& v : region.vertices) {
            const Vec2 p = v - box.center();
            const Vec2 x = bent(p.x, curl), z = bent(p.y, cup);
            const double y = x.y + z.y + p.y * std::sin(p.x * twist) + side * thickness;
            mesh.positions.emplace_back(static_cast<float>(x.x), static_cast<float>(y),
                                        static_cast<float>(z.x));
            mesh.uvs.emplace_back(static_cast<float>((v.x - box.min.x) / size.x),
                                  static_cast<float>((box.max.y - v.y) / size.y));
        }
    }
    const auto below = static_cast<std::uint32_t>(region.vertices.size());
    std::map<Edge, int> uses;
    for (const auto& t : region.triangles) {
        // Counter-clockwise in (x, z) is clockwise seen from above.
        mesh.triangles.push_back({t[0], t[2], t[1]});
        mesh.triangles.push_back({t[0] + below, t[1] + below, t[2] + below});
        for (unsigned k = 0; k < 3; ++k)
            ++uses[edge_of(t[k], t[(k + 1) % 3])];
    }
    for (const auto& t : region.triangles) {
        for (unsigned k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if (uses[edge_of(a, b)] > 1)
                continue;
            mesh.triangles.push_back({a, b, b + below});
            mesh.triangles.push_back({a, b + below, a + below});
        }
    }
    compute_normals(mesh, radians(50));
    return mesh;
}

} // namespace

Plugin<MakeMesh> sheet_component() {
    ParamSpec outline{.name = "outline",
                      .type = ParamType::object,
                      .families = {"region"},
                      .doc = "Its outline; a pointed leaf when not given.",
                      .optional = true};
    return component(
        "sheet", "A thin sheet cut out along an outline and bent: leaf, petal, paper.",
        {std::move(outline),
         optional_metres("thickness", "Thickness; 0.004 of the longest side by default."),
         angle_degrees("curl", "How far it is bent upwards along x, from end to end.", 0, -300,
                       300),
         angle_degrees("cup", "How far it is bent upwards along z.", 0, -300, 300),
         angle_degrees("twist", "How far its ends are turned about the x axis against each other.",
                       0, -90, 90)},
        sheet);
}

} // namespace scree
