// SPDX-License-Identifier: GPL-3.0-or-later
// Trilinear interpolation at many points. Such code is limited by its memory accesses: eight
// gathers of one corner each are replaced by loads of whole records.
#include "procedurals/solid/lattice/in_groups.h"
#include "procedurals/solid/lattice/lattice_quads.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedurals/solid/lattice/quads_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedurals/solid/lattice/records-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scree::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

using V = hn::Vec<Reals>;

/// The cell of a coordinate, reduced to one period, and the position within the cell.
HWY_INLINE hn::Vec<Words> cell_of(V place, V cells, hn::Vec<Words> mask, V& fraction) {
    const Reals d;
    const Words du;
    const V at = hn::Mul(place, cells);
    const V cell = hn::Floor(at);
    fraction = hn::Sub(at, cell);
    // After this addition the low bits of the mantissa hold the integer, up to 2^22.
    return hn::And(hn::BitCast(du, hn::Add(cell, hn::Set(d, 0x1.8p23F))), mask);
}

// Points per block, so that their cells stay in the L1 cache until they are used.
constexpr std::size_t block = 256;

struct QuadCells {
    HWY_ALIGN std::uint32_t quad[block];
    HWY_ALIGN std::uint32_t weights[block];
    HWY_ALIGN float fx[block];
    HWY_ALIGN float fz[block];
};

HWY_INLINE void find_cells(QuadCells& cells, int level, const float* x, const float* y,
                           const float* z, std::size_t count) {
    const Reals d;
    const Words du;
    const V side = hn::Set(d, static_cast<float>(1 << level));
    const auto mask = hn::Set(du, (1U << level) - 1);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        V fx, fy, fz;
        const auto cx = cell_of(hn::LoadU(d, x + i), side, mask, fx);
        const auto cy = cell_of(hn::LoadU(d, y + i), side, mask, fy);
        const auto cz = cell_of(hn::LoadU(d, z + i), side, mask, fz);
        const auto row = hn::Add(hn::ShiftLeftSame(cz, level), cy); // of n + 1 quads
        hn::Store(hn::Add(hn::Add(hn::ShiftLeftSame(row, level), row), cx), du, cells.quad + i);
        // Pairs of 16-bit weights, of a value and of its difference along y, both negated: -2^15,
        // since 2^15 does not fit into 16 bits, and -w, where w = round(2^15 fy) is the low half of
        // the float 384 + fy.
        const auto w = hn::BitCast(du, hn::Add(fy, hn::Set(d, 384.0F)));
        hn::Store(hn::Sub(hn::Set(du, 0x8000U), hn::ShiftLeft<16>(w)), du, cells.weights + i);
        hn::Store(fx, d, cells.fx + i);
        hn::Store(fz, d, cells.fz + i);
    }
}

HWY_INLINE void interpolate(const QuadCells& cells, const std::int16_t* quads, float step,
                            float* out, std::size_t count) {
    const Reals d;
    const hn::RebindToSigned<Reals> di;
    const hn::Repartition<std::int16_t, Reals> ds;
    const V unit = hn::Set(d, step * -0x1p-15F);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        // At z and z + 1, then both at x + 1.
        const Records corners = load_records(quads, cells.quad + i);
        const auto weights = hn::BitCast(ds, hn::Load(Words(), cells.weights + i));
        const auto along_y = [&](auto corner) {
            auto rest = hn::Zero(di);
            const auto sum = hn::ReorderWidenMulAccumulate(di, hn::BitCast(ds, corner), weights,
                                                           hn::Zero(di), rest);
            return hn::ConvertTo(d, hn::RearrangeToOddPlusEven(sum, rest));
        };
        const auto lerp = [](V from, V to, V share) {
            return hn::Add(from, hn::Mul(hn::Sub(to, from), share));
        };
        const V fx = hn::Load(d, cells.fx + i), fz = hn::Load(d, cells.fz + i);
        const V near = lerp(along_y(corners.first), along_y(corners.third), fx);
        const V far = lerp(along_y(corners.second), along_y(corners.fourth), fx);
        hn::StoreU(hn::Mul(lerp(near, far, fz), unit), d, out + i);
    }
}

/// `count` is a multiple of the number of lanes.
void fluctuations_of_quads(const LatticeQuads& quads, const float* x, const float* y,
                           const float* z, float* out, std::size_t count) {
    QuadCells cells;
    for (std::size_t first = 0; first < count; first += block) {
        const std::size_t part = std::min(block, count - first);
        find_cells(cells, quads.level(), x + first, y + first, z + first, part);
        interpolate(cells, quads.quads(), quads.step(), out + first, part);
    }
}

#else // no vector instructions: never called

void fluctuations_of_quads(const LatticeQuads&, const float*, const float*, const float*, float*,
                           std::size_t) {}

#endif

} // namespace scree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scree {

HWY_EXPORT(fluctuations_of_quads);

void vector_fluctuations(const LatticeQuads& quads, std::span<const float> x,
                         std::span<const float> y, std::span<const float> z, std::span<float> out) {
    in_groups(
        [&](const float* a, const float* b, const float* c, float* to, std::size_t count) {
            HWY_DYNAMIC_DISPATCH(fluctuations_of_quads)(quads, a, b, c, to, count);
        },
        out, x, y, z);
}

} // namespace scree
#endif
