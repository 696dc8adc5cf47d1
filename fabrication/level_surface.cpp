// SPDX-License-Identifier: GPL-3.0-or-later
#include "fabrication/level_surface.h"

#include "core/error.h"
#include "core/parallel.h"
#include "fabrication/cell_surface.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

namespace scree {

namespace {

constexpr int side = DistanceField::side;
constexpr int samples = DistanceField::samples;

/// The values of a block's points and of the adjacent points that its cells and edges use.
class Samples {
  public:
    float& at(int x, int y, int z) { return values_[std::size_t((z * 9 + y) * 9 + x)]; }
    bool inside(int x, int y, int z) { return at(x, y, z) < 0; }

  private:
    std::array<float, 9 * 9 * 9> values_;
};

/// The edges that begin in a block and cross the surface, as bits by axis and sample.
struct Crossed {
    static constexpr std::size_t words = 3 * samples / 64;
    std::array<std::uint64_t, words> bits{};
    std::array<std::uint16_t, words> before{}; // set bits in earlier words

    void count() {
        std::uint16_t sum = 0;
        for (std::size_t w = 0; w < words; ++w) {
            before[w] = sum;
            sum = std::uint16_t(sum + std::popcount(bits[w]));
        }
    }
    std::uint32_t total() const {
        return std::uint32_t(before.back()) + std::uint32_t(std::popcount(bits.back()));
    }
    std::uint32_t rank(std::size_t edge) const {
        const std::uint64_t lower = (std::uint64_t{1} << edge % 64) - 1;
        return before[edge / 64] + std::uint32_t(std::popcount(bits[edge / 64] & lower));
    }
};

/// A block that has values and the seven adjacent ones, numbered as the corners of a cell.
struct Neighbourhood {
    std::array<std::int64_t, 8> blocks; // index in the sorted list; -1: outside
};

class Polygoniser {
  public:
    Polygoniser(const DistanceField& field, double level)
        : field_(field), level_(float(level)), blocks_(field.blocks()), crossed_(blocks_.size()),
          first_vertex_(blocks_.size() + 1), first_triangle_(blocks_.size() + 1),
          first_line_(blocks_.size() + 1) {}

    LevelSurface run() {
        parallel_for(blocks_.size(), 64, [&](std::size_t b) { count(b); });
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            first_vertex_[b + 1] += first_vertex_[b];
            first_triangle_[b + 1] += first_triangle_[b];
            first_line_[b + 1] += first_line_[b];
        }
        if (first_vertex_.back() > std::numeric_limits<std::uint32_t>::max())
            throw Error::resource("the surface has more than 2^32 vertices");
        surface_.positions.resize(first_vertex_.back());
        surface_.triangles.resize(first_triangle_.back());
        surface_.line_vertices.resize(first_line_.back());
        parallel_for(blocks_.size(), 64, [&](std::size_t b) { emit(b); });
        return std::move(surface_);
    }

  private:
    Neighbourhood around(std::size_t b) const {
        Neighbourhood out;
        const LatticePoint at = DistanceField::block_of(blocks_[b].key);
        for (int n = 0; n < 8; ++n) {
            const std::uint64_t key =
                DistanceField::key_of({at.x + (n & 1), at.y + (n >> 1 & 1), at.z + (n >> 2)});
            // Blocks are sorted by rows, so most neighbours are adjacent in the list.
            const auto from = blocks_.begin() + std::int64_t(b);
            const auto found = n == 0 ? from
                                      : std::lower_bound(from, blocks_.end(), key,
                                                         [](const auto& block, std::uint64_t k) {
                                                             return block.key < k;
                                                         });
            out.blocks[std::size_t(n)] =
                found != blocks_.end() && found->key == key ? found - blocks_.begin() : -1;
        }
        return out;
    }

    void gather(const Neighbourhood& around, Samples& out) const {
        for (int n = 0; n < 8; ++n) {
            const std::int64_t b = around.blocks[std::size_t(n)];
            const float constant = (b < 0 ? field_.outer() : -field_.inner()) - level_;
            const DistanceField::Values* values = b < 0 ? nullptr : blocks_[std::size_t(b)].values;
            const auto range = [&](int axis) {
                return (n >> axis & 1) != 0 ? std::pair(side, side + 1) : std::pair(0, side);
            };
            for (int z = range(2).first; z < range(2).second; ++z)
                for (int y = range(1).first; y < range(1).second; ++y)
                    for (int x = range(0).first; x < range(0).second; ++x)
                        out.at(x, y, z) = values == nullptr
                                              ? constant
                                              : (*values)[std::size_t(DistanceField::sample(
                                                    x % side, y % side, z % side))] -
                                                    level_;
        }
    }

    template <class Body>
    static void each_cell(Samples& values, const Body& body) {
        for (int z = 0; z < side; ++z)
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x) {
                    unsigned inside = 0;
                    for (int c = 0; c < 8; ++c)
                        inside |=
                            unsigned(values.inside(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)))
                            << c;
                    if (inside != 0 && inside != 255)
                        body(x, y, z, inside);
                }
    }

    void count(std::size_t b) {
        if (blocks_[b].values == nullptr)
            return;
        Samples values;
        gather(around(b), values);
        Crossed& crossed = crossed_[b];
        std::size_t triangles = 0, lines = 0;
        each_cell(values, [&](int x, int y, int z, unsigned inside) {
            const auto at = std::size_t(DistanceField::sample(x, y, z));
            for (std::size_t axis = 0; axis < 3; ++axis)
                if ((inside & 1) != (inside >> (1U << axis) & 1)) {
                    const std::size_t edge = axis * samples + at;
                    crossed.bits[edge / 64] |= std::uint64_t{1} << edge % 64;
                    lines += axis == 2;
                }
            triangles += cell_surface(inside).size();
        });
        crossed.count();
        first_vertex_[b + 1] = crossed.total();
        first_triangle_[b + 1] = triangles;
        first_line_[b + 1] = lines;
    }

    void emit(std::size_t b) {
        if (blocks_[b].values == nullptr)
            return;
        Samples values;
        const Neighbourhood neighbours = around(b);
        gather(neighbours, values);
        const LatticePoint block = DistanceField::block_of(blocks_[b].key);
        std::size_t triangle = first_triangle_[b], line = first_line_[b];
        each_cell(values, [&](int x, int y, int z, unsigned inside) {
            for (int axis = 0; axis < 3; ++axis) {
                if ((inside & 1) == (inside >> (1U << axis) & 1))
                    continue;
                const Imath::V3d corner(block.x * side + x, block.y * side + y, block.z * side + z);
                const double from = values.at(x, y, z);
                const double to = values.at(x + (axis == 0), y + (axis == 1), z + (axis == 2));
                Imath::V3d position = corner;
                position[axis] += std::clamp(from / (from - to), 0.02, 0.98);
                const std::uint32_t vertex = vertex_at(neighbours, x, y, z, axis);
                surface_.positions[vertex] = position;
                if (axis == 2)
                    surface_.line_vertices[line++] = {int(corner.x), int(corner.y), position.z,
                                                      vertex};
            }
            for (const auto& edges : cell_surface(inside)) {
                Mesh::Triangle& out = surface_.triangles[triangle++];
                for (std::size_t k = 0; k < 3; ++k) {
                    const CellEdge e = cell_edge(edges[k]);
                    out[k] = vertex_at(neighbours, x + (e.lower & 1), y + (e.lower >> 1 & 1),
                                       z + (e.lower >> 2), e.axis);
                }
            }
        });
    }

    // The vertex on the edge that begins at a point of a block or at most one beyond it.
    std::uint32_t vertex_at(const Neighbourhood& neighbours, int x, int y, int z, int axis) const {
        const int n = x / side + 2 * (y / side) + 4 * (z / side);
        const std::int64_t b = neighbours.blocks[std::size_t(n)];
        assert(b >= 0); // near a sign change all points have values
        const auto sample = DistanceField::sample(x % side, y % side, z % side);
        return std::uint32_t(first_vertex_[std::size_t(b)]) +
               crossed_[std::size_t(b)].rank(std::size_t(axis * samples + sample));
    }

    const DistanceField& field_;
    float level_;
    std::vector<DistanceField::Block> blocks_;
    std::vector<Crossed> crossed_;
    std::vector<std::size_t> first_vertex_, first_triangle_, first_line_; // by block
    LevelSurface surface_;
};

} // namespace

LevelSurface level_surface(const DistanceField& field, double level) {
    return Polygoniser(field, level).run();
}

} // namespace scree
