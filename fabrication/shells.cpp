// SPDX-License-Identifier: GPL-3.0-or-later
#include "fabrication/shells.h"

#include "core/disjoint_sets.h"
#include "core/parallel.h"

#include <algorithm>
#include <tuple>

namespace scree {

namespace {

Shells label(const LevelSurface& surface) {
    DisjointSets sets(surface.positions.size());
    for (const Mesh::Triangle& t : surface.triangles) {
        sets.unite(t[0], t[1]);
        sets.unite(t[1], t[2]);
    }
    Shells shells;
    shells.of_vertex.resize(surface.positions.size());
    for (std::uint32_t v = 0; v < shells.of_vertex.size(); ++v) {
        const std::uint32_t root = sets.find(v);
        if (root == v) {
            shells.of_vertex[v] = std::uint32_t(shells.list.size());
            shells.list.emplace_back();
        } else {
            shells.of_vertex[v] = shells.of_vertex[root];
        }
    }
    return shells;
}

void measure(const LevelSurface& surface, Shells& shells) {
    // Relative to each shell's first vertex, so that volumes far from the origin stay accurate.
    std::vector<Imath::V3d> origin(shells.list.size());
    for (std::size_t v = shells.of_vertex.size(); v-- > 0;)
        origin[shells.of_vertex[v]] = surface.positions[v];
    for (const Mesh::Triangle& t : surface.triangles) {
        const std::uint32_t s = shells.of_vertex[t[0]];
        const Imath::V3d a = surface.positions[t[0]] - origin[s];
        const Imath::V3d b = surface.positions[t[1]] - origin[s];
        const Imath::V3d c = surface.positions[t[2]] - origin[s];
        shells.list[s].volume += a.dot(b.cross(c)) / 6;
        ++shells.list[s].triangles;
    }
}

// Finds each shell's parent with a stack of the shells that are entered and not left along the
// lattice lines.
void nest(const LevelSurface& surface, Shells& shells) {
    std::vector<LineVertex> vertices = surface.line_vertices;
    parallel_sort(vertices.begin(), vertices.end(), [](const LineVertex& a, const LineVertex& b) {
        return std::tie(a.y, a.x, a.z) < std::tie(b.y, b.x, b.z);
    });
    std::vector<bool> seen(shells.list.size());
    std::vector<std::uint32_t> inside;
    for (const LineVertex& v : vertices) {
        const std::uint32_t shell = shells.of_vertex[v.vertex];
        if (!inside.empty() && inside.back() == shell) {
            inside.pop_back();
            continue;
        }
        if (!seen[shell]) {
            seen[shell] = true;
            shells.list[shell].parent = inside.empty() ? Shell::none : inside.back();
        }
        inside.push_back(shell);
    }
}

} // namespace

Shells find_shells(const LevelSurface& surface) {
    Shells shells = label(surface);
    measure(surface, shells);
    nest(surface, shells);
    return shells;
}

} // namespace scree
