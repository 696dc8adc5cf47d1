// SPDX-License-Identifier: GPL-3.0-or-later
// Levels that are not stored, at a single point, as needed in close-ups. The variates of all levels
// are computed together; the value and gradient of each level are the four lanes of a vector. The
// results are bit-identical to those of add_levels_plainly.
#include "procedurals/solid/lattice/fluctuation_as_cpp.h"
#include "procedurals/solid/lattice/vector_path.h"

#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedurals/solid/lattice/levels_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedurals/solid/lattice/normal_variates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scree::HWY_NAMESPACE {

using solid::Fluctuation;
using solid::Lattice;
using solid::Triple;

#if HWY_TARGET == HWY_SCALAR // no vector instructions

void add_levels(const Lattice* lattice, int first, int last, float share, Triple p,
                Fluctuation* sum) {
    solid::add_levels_plainly(lattice, first, last, share, p, sum);
}

#else

using Reals = hn::CappedTag<float, 16>;
using Words = hn::RebindToUnsigned<Reals>;
using Four = hn::FixedTag<float, 4>;

// A level needs 19 of the 27 nodes of a cell, all but the corners. Five rows along x, through the
// centre of the cell and of its faces, have three of them; the four edges have one each.
constexpr std::size_t long_rows = 5, all_rows = 9, all_nodes = 3 * long_rows + 4;
constexpr std::uint32_t rows_y[all_rows] = {1, 0, 1, 2, 1, 0, 2, 0, 2};
constexpr std::uint32_t rows_z[all_rows] = {0, 1, 1, 1, 2, 0, 0, 2, 2};
// Order in memory: first nodes of the long rows, last nodes of the long rows, middle nodes of all
// rows.
constexpr std::size_t places[3] = {0, 2 * long_rows, long_rows};

/// The index in memory of the variate of node number x + 3 y + 9 z.
constexpr auto place_of = [] {
    std::array<std::size_t, 27> place{};
    for (std::size_t row = 0; row < all_rows; ++row)
        for (std::size_t x = 0; x < 3; ++x)
            if (x == 1 || row < long_rows)
                place[x + 3 * rows_y[row] + 9 * rows_z[row]] = places[x] + row;
    return place;
}();

constexpr std::size_t max_levels = LATTICE_MAX_LEVELS;
constexpr std::size_t beyond = 16; // elements that vectors access beyond the last one

/// The rows and nodes of the cells of all levels, and the variates of the nodes.
struct LevelCells {
    std::uint32_t y[all_rows * max_levels + beyond], z[all_rows * max_levels + beyond];
    std::uint32_t row[all_rows * max_levels + beyond], other[all_rows * max_levels + beyond];
    std::uint32_t x[3][max_levels]; // of the nodes along a row
    std::uint32_t node[all_nodes * max_levels + beyond],
        node_other[all_nodes * max_levels + beyond];
    float g[all_nodes * max_levels + beyond];
    std::size_t count = 0;
};

HWY_INLINE void add_cell(LevelCells& cells, const Lattice& lattice, int level, int cx, int cy,
                         int cz) {
    const std::uint32_t mask = solid::node_mask(&lattice, level);
    const auto at = [mask](int cell, std::uint32_t node) {
        return (2 * static_cast<std::uint32_t>(cell) + node) & mask;
    };
    std::uint32_t y[3], z[3];
    for (std::uint32_t i = 0; i < 3; ++i) {
        cells.x[i][cells.count] = at(cx, i) * 0x9e3779b1U;
        y[i] = lattice.key_a + at(cy, i) * 0x9e3779b9U;
        z[i] = at(cz, i) * 0x85ebca6bU +
               static_cast<std::uint32_t>(solid::source_level(&lattice, level)) * 0xc2b2ae35U;
    }
    for (std::size_t row = 0; row < all_rows; ++row) {
        cells.y[all_rows * cells.count + row] = y[rows_y[row]];
        cells.z[all_rows * cells.count + row] = z[rows_z[row]];
    }
    ++cells.count;
}

/// Copies `count` numbers, each increased by `plus`, and further ones up to a multiple of 4.
HWY_INLINE void copy(const std::uint32_t* from, std::size_t count, std::uint32_t plus,
                     std::uint32_t* to) {
    const hn::FixedTag<std::uint32_t, 4> d;
    for (std::size_t i = 0; i < count; i += 4)
        hn::StoreU(hn::Add(hn::LoadU(d, from + i), hn::Set(d, plus)), d, to + i);
}

/// See row_bits, node_bits and normal_variate.
HWY_INLINE void draw(LevelCells& cells, const Lattice& lattice) {
    const Reals d;
    const Words du;
    const auto key = hn::Set(du, lattice.key_b);
    const std::size_t row_count = all_rows * cells.count, node_count = all_nodes * cells.count;
    for (std::size_t i = 0; i < row_count; i += hn::Lanes(d)) {
        const auto y = scramble(du, hn::LoadU(du, cells.y + i));
        const auto row = scramble(du, hn::Xor(y, hn::LoadU(du, cells.z + i)));
        hn::StoreU(row, du, cells.row + i);
        hn::StoreU(scramble(du, hn::Add(row, key)), du, cells.other + i);
    }
    for (std::size_t cell = 0; cell < cells.count; ++cell)
        for (const std::size_t x : {0, 2, 1}) { // ascending in memory: each overrun is overwritten
            const std::size_t rows = x == 1 ? all_rows : long_rows;
            const std::size_t to = all_nodes * cell + places[x];
            copy(cells.row + all_rows * cell, rows, cells.x[x][cell], cells.node + to);
            copy(cells.other + all_rows * cell, rows, 0, cells.node_other + to);
        }
    for (std::size_t i = 0; i < node_count; i += hn::Lanes(d)) {
        const auto bits =
            node_bits(du, hn::LoadU(du, cells.node + i), hn::LoadU(du, cells.node_other + i));
        hn::StoreU(normal_variate(d, bits), d, cells.g + i);
    }
}

/// The field of a cell from its variates: the value and the slopes along x, y and z in the four
/// lanes. `x`, `y`, `z` are the weights of each lane. See `field_of_variates`.
HWY_INLINE hn::Vec<Four> field_of_variates(const float* variates, const hn::Vec<Four>* x,
                                           const hn::Vec<Four>* y, const hn::Vec<Four>* z) {
    using V = hn::Vec<Four>;
    const Four d;
    const auto g = [&](std::size_t node) { return hn::Set(d, variates[place_of[node]]); };
    const auto weight = [](V a, V b, V c) { return hn::Mul(hn::Mul(a, b), c); };
    V faces[3][2];
    const V centre = weight(x[1], y[1], z[1]);
    const V share = hn::Mul(centre, hn::Set(d, 1.0F / 6.0F));
    V sum = hn::Mul(centre, g(13));
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t i = 2 * side;
        faces[0][side] = hn::Add(weight(x[i], y[1], z[1]), share);
        faces[1][side] = hn::Add(weight(x[1], y[i], z[1]), share);
        faces[2][side] = hn::Add(weight(x[1], y[1], z[i]), share);
        sum = hn::Add(sum, hn::Add(hn::Add(hn::Mul(faces[0][side], g(i + 12)),
                                           hn::Mul(faces[1][side], g(3 * i + 10))),
                                   hn::Mul(faces[2][side], g(9 * i + 4))));
    }
    const V quarter = hn::Set(d, 0.25F);
    const auto edge = [&](V product, V face_a, V face_b, std::size_t node) {
        const V total = hn::Add(product, hn::Mul(quarter, hn::Add(face_a, face_b)));
        sum = hn::Add(sum, hn::Mul(total, g(node)));
    };
    for (std::size_t b = 0; b < 2; ++b)
        for (std::size_t a = 0; a < 2; ++a) {
            const std::size_t i = 2 * a, j = 2 * b;
            edge(weight(x[1], y[i], z[j]), faces[1][a], faces[2][b], 1 + 3 * i + 9 * j);
            edge(weight(x[i], y[1], z[j]), faces[0][a], faces[2][b], i + 3 + 9 * j);
            edge(weight(x[i], y[j], z[1]), faces[0][a], faces[1][b], i + 3 * j + 9);
        }
    return sum;
}

void add_levels(const Lattice* lattice, int first, int last, float share, Triple p,
                Fluctuation* sum) {
    const Four d;
    using V = hn::Vec<Four>;
    if (share > 0)
        ++last;
    else
        share = 1;
    LevelCells cells;
    float fractions[LATTICE_MAX_LEVELS][3];
    for (int level = first; level <= last; ++level) {
        const auto width = static_cast<float>(1 << (level - 1));
        const float x = p.x * width, y = p.y * width, z = p.z * width;
        const float cx = std::floor(x), cy = std::floor(y), cz = std::floor(z);
        float* fraction = fractions[level - first];
        fraction[0] = x - cx;
        fraction[1] = y - cy;
        fraction[2] = z - cz;
        add_cell(cells, *lattice, level, static_cast<int>(cx), static_cast<int>(cy),
                 static_cast<int>(cz));
    }
    draw(cells, *lattice);
    const float start[4] = {sum->value, sum->gradient.x, sum->gradient.y, sum->gradient.z};
    V total = hn::LoadU(d, start);
    for (int level = first; level <= last; ++level) {
        V weights[3][3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float weight[3], slope[3];
            solid::axis_weights(fractions[level - first][axis], weight, slope);
            const auto derived = hn::Eq(hn::Iota(d, 0), hn::Set(d, static_cast<float>(axis + 1)));
            for (std::size_t i = 0; i < 3; ++i)
                weights[axis][i] =
                    hn::IfThenElse(derived, hn::Set(d, slope[i]), hn::Set(d, weight[i]));
        }
        const auto width = static_cast<float>(1 << (level - 1));
        const float units[4] = {1, width, width, width};
        float part = lattice->amplitude[level];
        if (level == last)
            part = share * part;
        const V found =
            field_of_variates(cells.g + all_nodes * static_cast<std::size_t>(level - first),
                              weights[0], weights[1], weights[2]);
        total = hn::Add(total, hn::Mul(hn::Mul(found, hn::LoadU(d, units)), hn::Set(d, part)));
    }
    float end[4];
    hn::StoreU(total, d, end);
    sum->value = end[0];
    sum->gradient = {end[1], end[2], end[3]};
}

#endif

} // namespace scree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scree {

HWY_EXPORT(add_levels);

namespace solid {

void add_levels(const Lattice* lattice, int first, int last, float share, Triple p,
                Fluctuation* sum) {
    if (last < first && !(share > 0))
        return;
    if (scalar_path_in_use())
        add_levels_plainly(lattice, first, last, share, p, sum);
    else
        HWY_DYNAMIC_DISPATCH(scree::add_levels)(lattice, first, last, share, p, sum);
}

} // namespace solid

} // namespace scree
#endif
