// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's source functions at many points. Exponentials and sines are polynomials without fused
// multiply-add, so that results are the same on every machine.
#include "procedurals/solid/lattice/in_groups.h"
#include "procedurals/solid/lattice/vector_path.h"
#include "procedurals/solid/marble/stripes.h"
#include "procedurals/solid/marble/vein_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedurals/solid/marble/stripes_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedurals/solid/lattice/records-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scree::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

using V = hn::Vec<Reals>;

/// A polynomial by Horner's scheme, highest power first, without fused multiply-add.
template <class... Floats>
HWY_INLINE V polynomial(V at, float first, Floats... others) {
    const Reals d;
    V sum = hn::Set(d, first);
    ((sum = hn::Add(hn::Mul(sum, at), hn::Set(d, others))), ...);
    return sum;
}

// Adding it leaves the rounded integer, up to 2^22, in the low bits of the mantissa.
constexpr float rounds = 0x1.8p23F;

/// 2^t with a relative error of 5e-7, for -126 <= t <= 0; exact at integers. (The minimax
/// polynomial of the relative error among those that are 1 at 0.)
HWY_INLINE V exp2(V t) {
    const Reals d;
    const hn::RebindToUnsigned<Reals> du;
    const V shifted = hn::Add(t, hn::Set(d, rounds));
    const V f = hn::Sub(t, hn::Sub(shifted, hn::Set(d, rounds))); // in [-1/2, 1/2]
    const V p = polynomial(f, 0.00111255073F, 0.00966628268F, 0.0555740036F, 0.240223512F,
                           0.693142831F, 1.0F);
    const auto exponent = hn::ShiftLeft<23>(hn::BitCast(du, shifted));
    return hn::BitCast(d, hn::Add(hn::BitCast(du, p), exponent));
}

/// sin(2 pi t) with an error of 1e-7. (The minimax polynomial of the relative error over a quarter
/// turn.)
HWY_INLINE V sine(V t) {
    const Reals d;
    // Reduction to a quarter turn: sin(2 pi t) = sin(2 pi (1/4 - |t - 1/4 - n|)).
    const V from_top = hn::Sub(t, hn::Set(d, 0.25F));
    const V whole = hn::Sub(hn::Add(from_top, hn::Set(d, rounds)), hn::Set(d, rounds));
    const V w = hn::Sub(hn::Set(d, 0.25F), hn::Abs(hn::Sub(from_top, whole)));
    return hn::Mul(w, polynomial(hn::Mul(w, w), 39.7109184F, -76.5749893F, 81.6022339F,
                                 -41.3416786F, 6.28318548F));
}

/// The sum of the veins by the formula.
HWY_INLINE V sum_of_veins(const VeinTable& table, V at) {
    const Reals d;
    const V none = hn::Zero(d), least = hn::Set(d, -126.0F);
    const float period = table.period();
    V sum = none;
    for (const solid::Vein& vein : table.veins()) {
        V away = hn::Sub(at, hn::Set(d, vein.centre));
        if (period > 0)
            away = hn::Sub(away, hn::Mul(hn::Set(d, period),
                                         hn::Round(hn::Mul(away, hn::Set(d, 1 / period)))));
        const V inwards = hn::Sub(hn::Set(d, vein.half_width), hn::Abs(away));
        const V t = hn::Mul(inwards, hn::Set(d, vein.rate));
        sum = hn::Add(sum, exp2(hn::Max(hn::Min(t, none), least)));
    }
    return sum;
}

HWY_INLINE V cubic(const Records& powers, V at) {
    const Reals d;
    V sum = hn::Mul(hn::BitCast(d, powers.fourth), at);
    sum = hn::Mul(hn::Add(sum, hn::BitCast(d, powers.third)), at);
    sum = hn::Mul(hn::Add(sum, hn::BitCast(d, powers.second)), at);
    return hn::Add(sum, hn::BitCast(d, powers.first));
}

/// Replaces NaN lanes of `sum`, which lie in bins with edges, by their values. `number` is that of
/// the divided bin, `from_middle` the position in the bin and `z` that on the axis.
HWY_NOINLINE V sum_at_edges(const VeinTable& table, V sum, hn::Vec<Words> number, V from_middle,
                            V z) {
    const Reals d;
    const hn::RebindToSigned<Reals> di;
    const auto fitted = hn::Eq(sum, sum);
    constexpr int size = sizeof(VeinTable::Divided) / sizeof(float);
    const float* bins = table.divided().data()->before.powers;
    const auto index = hn::BitCast(di, hn::And(number, hn::Set(Words(), 0x7fffffU)));
    const auto divided =
        hn::Mul(hn::IfThenZeroElse(hn::RebindMask(di, fitted), index), hn::Set(di, size));
    const auto after = hn::Ge(from_middle, hn::GatherIndex(d, bins + 8, divided));
    const auto at = hn::Add(divided, hn::IfThenElseZero(hn::RebindMask(di, after), hn::Set(di, 4)));
    const auto power = [&](int i) {
        return hn::BitCast(Words(), hn::GatherIndex(d, bins + i, at));
    };
    const Records powers{power(0), power(1), power(2), power(3)};
    sum = hn::IfThenElse(fitted, sum, cubic(powers, from_middle));
    const auto all_fitted = hn::Eq(sum, sum);
    if (HWY_LIKELY(hn::AllTrue(d, all_fitted)))
        return sum;
    return hn::IfThenElse(all_fitted, sum, sum_of_veins(table, z));
}

// Points per block, so that their bins stay in the L1 cache until they are used.
constexpr std::size_t block = 256;

/// The veins at z - displacement d; `count` is a multiple of the number of lanes.
void values_of_veins(const VeinTable& table, const float* z, const float* displaced,
                     float displacement, float* out, std::size_t count) {
    const Reals d;
    const Words du;
    const V displacement_all = hn::Set(d, displacement), one = hn::Set(d, 1.0F),
            integer = hn::Set(d, rounds);
    const V lowest = hn::Set(d, table.first()), highest = hn::Set(d, table.last());
    const V scale = hn::Set(d, table.scale());
    const auto mask = hn::Set(du, static_cast<std::uint32_t>(2 * (table.bins().size() - 1)));
    const V count_of_bins = hn::Set(d, static_cast<float>(table.bins().size()));
    const V periods_per_bin = hn::Set(d, 1 / static_cast<float>(table.bins().size()));
    const auto place = [&](std::size_t i) {
        return hn::Sub(hn::LoadU(d, z + i), hn::Mul(displacement_all, hn::LoadU(d, displaced + i)));
    };
    // Converts to bins, and with a period to the one around 0; exact up to the rounding of the
    // scaling.
    const auto in_bins = [&](V at) {
        if (table.period() <= 0)
            return hn::Mul(hn::Min(hn::Max(at, lowest), highest), scale);
        const V scaled = hn::Mul(at, scale);
        const V periods = hn::Round(hn::Mul(scaled, periods_per_bin));
        return hn::Sub(scaled, hn::Mul(periods, count_of_bins));
    };
    HWY_ALIGN std::uint32_t bins[block];
    HWY_ALIGN float from_middles[block];
    for (std::size_t first = 0; first < count; first += block) {
        const std::size_t part = std::min(block, count - first);
        for (std::size_t i = 0; i < part; i += hn::Lanes(d)) {
            const V at = in_bins(place(first + i));
            const V number = hn::Add(at, integer); // in the low bits of the mantissa
            const auto bits = hn::BitCast(du, number);
            hn::Store(hn::And(hn::Add(bits, bits), mask), du, bins + i); // a bin has 16 bytes
            hn::Store(hn::Sub(at, hn::Sub(number, integer)), d, from_middles + i);
        }
        for (std::size_t i = 0; i < part; i += hn::Lanes(d)) {
            const Records powers = load_records(table.bins().data(), bins + i);
            const V from_middle = hn::Load(d, from_middles + i);
            V sum = cubic(powers, from_middle);
            if (HWY_UNLIKELY(!hn::AllTrue(d, hn::Eq(sum, sum))))
                sum = sum_at_edges(table, sum, powers.second, from_middle, place(first + i));
            hn::StoreU(hn::Min(sum, one), d, out + first + i);
        }
    }
}

/// See ring_values; `count` is a multiple of the number of lanes.
void values_of_rings(const PlainWood& wood, const float* x, const float* y,
                     const float* fluctuation, float* out, std::size_t count) {
    const Reals d;
    const V middle_x = hn::Set(d, wood.x), middle_y = hn::Set(d, wood.y);
    const V rings = hn::Set(d, wood.rings), displacement = hn::Set(d, wood.displacement);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const V dx = hn::Sub(hn::LoadU(d, x + i), middle_x);
        const V dy = hn::Sub(hn::LoadU(d, y + i), middle_y);
        const V r = hn::Sqrt(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)));
        const V moved = hn::Sub(r, hn::Mul(displacement, hn::LoadU(d, fluctuation + i)));
        hn::StoreU(sine(hn::Mul(rings, moved)), d, out + i);
    }
}

#else // no vector instructions: never called

void values_of_veins(const VeinTable&, const float*, const float*, float, float*, std::size_t) {}
void values_of_rings(const PlainWood&, const float*, const float*, const float*, float*,
                     std::size_t) {}

#endif

} // namespace scree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scree {

namespace {

HWY_EXPORT(values_of_veins);
HWY_EXPORT(values_of_rings);

/// Eq. 8 as printed.
float plain_value(const VeinTable& table, float z) {
    float sum = 0;
    for (const solid::Vein& vein : table.veins()) {
        float away = z - vein.centre;
        if (table.period() > 0)
            away -= table.period() * std::round(away / table.period());
        const float distance = std::abs(away) - vein.half_width;
        sum += distance > 0 ? std::exp2(-vein.rate * distance) : 1;
    }
    return std::min(sum, 1.0F);
}

} // namespace

void VeinTable::values(std::span<const float> z, std::span<const float> d, float displacement,
                       std::span<float> out) const {
    if (scalar_path_in_use())
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = plain_value(*this, z[i] - displacement * d[i]);
    else
        in_groups(
            [&](const float* a, const float* b, float* to, std::size_t count) {
                HWY_DYNAMIC_DISPATCH(values_of_veins)(*this, a, b, displacement, to, count);
            },
            out, z, d);
}

void ring_values(const PlainWood& wood, std::span<const float> x, std::span<const float> y,
                 std::span<const float> d, std::span<float> out) {
    if (scalar_path_in_use())
        for (std::size_t i = 0; i < out.size(); ++i) {
            const float dx = x[i] - wood.x, dy = y[i] - wood.y;
            const float turns =
                wood.rings * (std::sqrt(dx * dx + dy * dy) - wood.displacement * d[i]);
            out[i] = static_cast<float>(std::sin(2 * std::numbers::pi * double(turns)));
        }
    else
        in_groups(
            [&](const float* a, const float* b, const float* c, float* to, std::size_t count) {
                HWY_DYNAMIC_DISPATCH(values_of_rings)(wood, a, b, c, to, count);
            },
            out, x, y, d);
}

} // namespace scree
#endif
