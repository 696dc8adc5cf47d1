// SPDX-License-Identifier: GPL-3.0-or-later
#include "fabrication/cell_surface.h"

#include "core/math.h"

#include <cassert>
#include <limits>
#include <utility>

namespace scree {

namespace {

using Triangles = std::vector<std::array<std::uint8_t, 3>>;
using Loop = std::vector<std::uint8_t>;

constexpr int bit(int axis) { return 1 << axis % 3; }

// The number of the edge between two adjacent corners.
int edge_between(int a, int b) {
    const int lower = a & b;
    const int axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
    return 4 * axis + ((lower & bit(axis + 1)) != 0 ? 1 : 0) +
           ((lower & bit(axis + 2)) != 0 ? 2 : 0);
}

// The corners of the face at the near or far end of an axis, counter-clockwise seen from outside.
std::array<int, 4> face_corners(int axis, bool far) {
    const int u = bit(axis + 1), v = bit(axis + 2);
    const int base = far ? bit(axis) : 0;
    if (far)
        return {base, base | u, base | u | v, base | v};
    return {base, base | v, base | u | v, base | u};
}

// The faces that the edge lies in, as bits.
unsigned faces_of(int edge) {
    const CellEdge e = cell_edge(edge);
    unsigned faces = 0;
    for (const int axis : {(e.axis + 1) % 3, (e.axis + 2) % 3})
        faces |= 1U << (2 * axis + ((e.lower & bit(axis)) != 0 ? 1 : 0));
    return faces;
}

// For each crossing the next one on its loop: on a face, the surface connects the crossing at which
// the face's boundary enters the solid to the next one, at which it leaves the solid.
std::array<int, 12> next_crossings(unsigned inside) {
    std::array<int, 12> next;
    next.fill(-1);
    const auto is_inside = [&](int corner) { return (inside >> corner & 1) != 0; };
    for (int face = 0; face < 6; ++face) {
        const std::array<int, 4> ring = face_corners(face / 2, face % 2 != 0);
        const auto at = [&](int k) { return ring[std::size_t(k % 4)]; };
        for (int k = 0; k < 4; ++k) {
            if (is_inside(at(k)) || !is_inside(at(k + 1)))
                continue;
            int last = k + 1;
            while (is_inside(at(last + 1)))
                ++last;
            next[std::size_t(edge_between(at(k), at(k + 1)))] =
                edge_between(at(last), at(last + 1));
        }
    }
    return next;
}

std::vector<Loop> loops(unsigned inside) {
    std::array<int, 12> next = next_crossings(inside);
    std::vector<Loop> out;
    for (std::size_t start = 0; start < 12; ++start) {
        if (next[start] < 0)
            continue;
        Loop loop;
        for (int edge = int(start); next[std::size_t(edge)] >= 0;) {
            loop.push_back(std::uint8_t(edge));
            edge = std::exchange(next[std::size_t(edge)], -1);
        }
        out.push_back(std::move(loop));
    }
    return out;
}

Vec3 middle(int edge) {
    const CellEdge e = cell_edge(edge);
    Vec3 p(float(e.lower & 1), float(e.lower >> 1 & 1), float(e.lower >> 2));
    p[e.axis] = 0.5F;
    return p;
}

/// The minimum-area triangulation of a loop (Klincsek 1980) for crossings in the middle of their
/// edges, without diagonals that lie in a face.
class LoopTriangulation {
  public:
    explicit LoopTriangulation(const Loop& loop) : loop_(loop) {}

    // Triangulates the polygon of the crossings first ... last and returns its area.
    float add(std::size_t first, std::size_t last, Triangles* out) const {
        if (last - first < 2)
            return 0;
        float least = std::numeric_limits<float>::infinity();
        std::size_t best = first;
        for (std::size_t k = first + 1; k < last; ++k) {
            if (!allowed(first, k) || !allowed(k, last))
                continue;
            const float area =
                triangle_area(first, k, last) + add(first, k, nullptr) + add(k, last, nullptr);
            if (area < least) {
                least = area;
                best = k;
            }
        }
        if (out != nullptr) {
            assert(best != first);
            out->push_back({loop_[first], loop_[best], loop_[last]});
            add(first, best, out);
            add(best, last, out);
        }
        return least;
    }

  private:
    bool allowed(std::size_t a, std::size_t b) const {
        return b - a == 1 || (faces_of(loop_[a]) & faces_of(loop_[b])) == 0;
    }
    float triangle_area(std::size_t a, std::size_t b, std::size_t c) const {
        const Vec3 p = middle(loop_[a]);
        return (middle(loop_[b]) - p).cross(middle(loop_[c]) - p).length();
    }

    const Loop& loop_;
};

std::array<Triangles, 256> all_cells() {
    std::array<Triangles, 256> table;
    for (unsigned inside = 0; inside < 256; ++inside)
        for (const Loop& loop : loops(inside))
            LoopTriangulation(loop).add(0, loop.size() - 1, &table[inside]);
    return table;
}

} // namespace

CellEdge cell_edge(int edge) {
    const int axis = edge / 4;
    return {((edge & 1) != 0 ? bit(axis + 1) : 0) | ((edge & 2) != 0 ? bit(axis + 2) : 0), axis};
}

const Triangles& cell_surface(unsigned inside) {
    static const std::array<Triangles, 256> table = all_cells();
    return table[inside];
}

} // namespace scree
