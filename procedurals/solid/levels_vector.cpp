// SPDX-License-Identifier: GPL-3.0-or-later
// Levels that are not stored, at one point, as renders near a surface ask them: the variates of all
// levels' nodes together, and each level's value and gradient as the four lanes of a vector. The
// bits are those of add_levels_plainly.
#include "procedurals/solid/lattice_text.h"
#include "procedurals/solid/vector_path.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedurals/solid/levels_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedurals/solid/normal_variates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scree::HWY_NAMESPACE {

using solid::Fluctuation;
using solid::Lattice;
using solid::Triple;

#if HWY_TARGET == HWY_SCALAR // no vectors at all

void add_levels(const Lattice* lattice, int first, int last, float share, Triple p,
                Fluctuation* sum) {
    solid::add_levels_plainly(lattice, first, last, share, p, sum);
}

#else

using Reals = hn::CappedTag<float, 16>;
using Words = hn::RebindToUnsigned<Reals>;
using Four = hn::FixedTag<float, 4>;

// A level asks for the 27 nodes of a cell: 9 rows of 3.
constexpr std::size_t row_count = 9 * LATTICE_MOST_LEVELS + 16; // and what a vector may go beyond

/// What the rows' random bits come from, and their nodes' variates.
struct Rows {
    std::uint32_t y[row_count];
    std::uint32_t z[row_count];
    std::uint32_t x[3][row_count]; // of their nodes
    float g[3][row_count];
    std::size_t count = 0;
};

/// The rows of one level's cell.
HWY_INLINE void add_rows(Rows& rows, const Lattice& lattice, int level, int cx, int cy, int cz) {
    const std::uint32_t mask = solid::node_mask(&lattice, level);
    const auto at = [mask](int cell, std::uint32_t node) {
        return (2 * static_cast<std::uint32_t>(cell) + node) & mask;
    };
    std::uint32_t* y = rows.y + rows.count;
    std::uint32_t* z = rows.z + rows.count;
    for (std::uint32_t k = 0; k < 3; ++k)
        for (std::uint32_t j = 0; j < 3; ++j) {
            *y++ = lattice.key_a + at(cy, j) * 0x9e3779b9U;
            *z++ = at(cz, k) * 0x85ebca6bU + static_cast<std::uint32_t>(level) * 0xc2b2ae35U;
        }
    for (std::uint32_t i = 0; i < 3; ++i)
        std::fill_n(rows.x[i] + rows.count, 9, at(cx, i) * 0x9e3779b1U);
    rows.count += 9;
}

/// See row_bits, node_bits and normal_variate.
HWY_INLINE void draw(Rows& rows, const Lattice& lattice) {
    const Reals d;
    const Words du;
    const auto key = hn::Set(du, lattice.key_b);
    for (std::size_t at = 0; at < rows.count; at += hn::Lanes(d)) {
        const auto y = scramble(du, hn::LoadU(du, rows.y + at));
        const auto row = scramble(du, hn::Xor(y, hn::LoadU(du, rows.z + at)));
        const auto other = scramble(du, hn::Add(row, key));
        for (std::size_t i = 0; i < 3; ++i) {
            const auto place = hn::Add(hn::LoadU(du, rows.x[i] + at), row);
            hn::StoreU(normal_variate(d, node_bits(du, place, other)), d, rows.g[i] + at);
        }
    }
}

/// What a cell's variates mean at a place in it: the value and the slopes along x, y and z in the
/// four lanes; `x`, `y`, `z` are each lane's weights. See carried.
HWY_INLINE hn::Vec<Four> carried(const Rows& rows, std::size_t at, const hn::Vec<Four>* x,
                                 const hn::Vec<Four>* y, const hn::Vec<Four>* z) {
    using V = hn::Vec<Four>;
    const Four d;
    const auto g = [&](std::size_t node) { return hn::Set(d, rows.g[node % 3][at + node / 3]); };
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
    const auto edge = [&](V own, V one, V another, std::size_t node) {
        const V all = hn::Add(own, hn::Mul(quarter, hn::Add(one, another)));
        sum = hn::Add(sum, hn::Mul(all, g(node)));
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
    Rows rows;
    float fractions[LATTICE_MOST_LEVELS][3];
    for (int level = first; level <= last; ++level) {
        const auto cells = static_cast<float>(1 << (level - 1));
        const float x = p.x * cells, y = p.y * cells, z = p.z * cells;
        const float cx = std::floor(x), cy = std::floor(y), cz = std::floor(z);
        float* fraction = fractions[level - first];
        fraction[0] = x - cx;
        fraction[1] = y - cy;
        fraction[2] = z - cz;
        add_rows(rows, *lattice, level, static_cast<int>(cx), static_cast<int>(cy),
                 static_cast<int>(cz));
    }
    const std::size_t beyond = (rows.count + 15) / 16 * 16; // nobody asks, but somebody reads
    for (std::uint32_t* numbers : {rows.y, rows.z, rows.x[0], rows.x[1], rows.x[2]})
        std::fill(numbers + rows.count, numbers + beyond, 0U);
    draw(rows, *lattice);
    const float start[4] = {sum->value, sum->gradient.x, sum->gradient.y, sum->gradient.z};
    V total = hn::LoadU(d, start);
    for (int level = first; level <= last; ++level) {
        V weights[3][3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float weight[3], slope[3];
            solid::axis_weights(fractions[level - first][axis], weight, slope);
            const auto own = hn::Eq(hn::Iota(d, 0), hn::Set(d, static_cast<float>(axis + 1)));
            for (std::size_t i = 0; i < 3; ++i)
                weights[axis][i] = hn::IfThenElse(own, hn::Set(d, slope[i]), hn::Set(d, weight[i]));
        }
        const auto cells = static_cast<float>(1 << (level - 1));
        const float units[4] = {1, cells, cells, cells};
        float part = lattice->spread[level];
        if (level == last)
            part = share * part;
        const V found = carried(rows, 9 * static_cast<std::size_t>(level - first), weights[0],
                                weights[1], weights[2]);
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
