// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates marble.cl at several points, as needed for a batch of paths: one point, or one part of
// an elongated filter, in each lane.
#include "procedurals/solid/marble/marble_vector.h"

#include "procedurals/solid/filter_parts.h"
#include "procedurals/solid/lattice/vector_path.h"

#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedurals/solid/marble/marble_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedurals/solid/lattice/fluctuation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scree::HWY_NAMESPACE {

using solid::Field;
using solid::Marble;
using solid::VeinLayer;

#if HWY_TARGET == HWY_SCALAR // no vector instructions

bool evaluate_marble(const Field&, const Marble&, FilterParts&) { return false; }

#else

/// See table_row.
HWY_INLINE V table_row(const float* table, I row, I points, V place, V share, V& slope) {
    const V count = real(points);
    const V at = hn::Mul(place, count);
    const I i = hn::ConvertTo(Ints(), at);
    const I mask = hn::Sub(points, all(1));
    const V low = gathered(table, hn::Add(row, hn::And(i, mask)));
    const V high = gathered(table, hn::Add(row, hn::And(hn::Add(i, all(1)), mask)));
    const V rise = hn::Sub(high, low);
    slope = hn::Add(slope, hn::Mul(hn::Mul(share, rise), count));
    return hn::Mul(share, hn::Add(low, hn::Mul(rise, hn::Sub(at, real(i)))));
}

/// See veins_table.
HWY_INLINE V veins_table(const VeinLayer& layer, V z, V sigma, V& slope) {
    const V length = all(layer.length), one = all(1.0F);
    const V turns = hn::Div(hn::Sub(z, all(layer.start_of_table)), length);
    const V place = hn::Sub(turns, hn::Floor(turns));
    const V wide = hn::Mul(hn::Div(sigma, length), all(float(PROFILE_POINTS) / PROFILE_FINEST));
    const Mask narrow = hn::Lt(wide, one);
    const I bits = hn::BitCast(Ints(), wide);
    const I level = hn::Sub(hn::ShiftRight<23>(bits), all(127));
    const hn::Mask<Ints> flat = hn::Gt(level, all(PROFILE_LEVELS - 2));
    const V mantissa = hn::BitCast(Reals(), hn::Or(hn::And(bits, all(0x7fffff)), all(0x3f800000)));
    const V share = chosen(narrow, hn::Mul(wide, wide), hn::Sub(mantissa, one));
    const I all_points = all(PROFILE_POINTS);
    const I shift = hn::Max(hn::Min(level, all(PROFILE_LEVELS - 2)), all(0));
    const I points = hn::Shr(all_points, shift); // number of points of the level
    const I row = hn::IfThenElse(hn::RebindMask(Ints(), narrow), hn::Zero(Ints()),
                                 hn::Sub(all(3 * PROFILE_POINTS), hn::Add(points, points)));
    const I next_points =
        hn::IfThenElse(hn::RebindMask(Ints(), narrow), all_points, hn::ShiftRight<1>(points));
    V steepness = hn::Zero(Reals());
    const V first = table_row(layer.table, row, points, place, hn::Sub(one, share), steepness);
    const V second =
        table_row(layer.table, hn::Add(row, points), next_points, place, share, steepness);
    const Mask mean = hn::RebindMask(Reals(), flat);
    V value = chosen(mean, all(layer.mean), hn::Add(first, second));
    slope = hn::IfThenZeroElse(mean, hn::Div(steepness, length));
    if (layer.period == 0) {
        const Mask beyond = hn::Or(hn::Lt(turns, hn::Zero(Reals())), hn::Ge(turns, one));
        value = hn::IfThenZeroElse(beyond, value);
        slope = hn::IfThenZeroElse(beyond, slope);
    }
    return value;
}

/// A filter, or a part of one, in every lane.
struct Filters {
    Triples position, across, along;
    V random;
};

/// See layer_value. `least` is lowered to the filter's deviation: a table
/// cannot answer without.
HWY_INLINE V layer_value(const Field& field, const VeinLayer& layer, const Filters& at,
                         Triples& slope, V& least) {
    const Triples axis = all(layer.axis);
    const V displacement = all(layer.displacement);
    Triples p = at.position, u = at.across, v = at.along, gradient = axis;
    V variance = hn::Zero(Reals());
    for (int i = 0; i <= layer.iterations; ++i) {
        const Fluctuations d = fluctuation_at(field, layer.placement, p,
                                              filter_width(layer.placement, u, v), at.random);
        const V shift = hn::Mul(displacement, d.value);
        gradient = minus(axis, scaled(d.gradient, displacement));
        u = minus(at.across, scaled(axis, hn::Mul(displacement, dot3(d.gradient, u))));
        v = minus(at.along, scaled(axis, hn::Mul(displacement, dot3(d.gradient, v))));
        p = minus(at.position, scaled(axis, shift));
        variance = hn::Mul(all(solid::square(layer.displacement)), d.variance);
    }
    const V side = dot3(axis, u), other = dot3(axis, v);
    const V sides = hn::Add(hn::Mul(side, side), hn::Mul(other, other));
    const V sigma = hn::Sqrt(hn::Add(variance, hn::Mul(sides, all(1.0F / 12.0F))));
    least = hn::Min(least, sigma);
    V steepness;
    const V z = hn::Sub(dot3(axis, p), all(layer.start));
    const V value = veins_table(layer, z, sigma, steepness);
    slope = scaled(gradient, steepness);
    return value;
}

HWY_INLINE Triples lerp(const Triples& a, const Triples& b, V share) {
    return plus(scaled(a, hn::Sub(all(1.0F), share)), scaled(b, share));
}

/// See smooth.
HWY_INLINE V smooth(float low, float high, V v) {
    const V t = clamped(hn::Div(hn::Sub(v, all(low)), all(high - low)), 0, 1);
    return hn::Mul(hn::Mul(t, t), hn::Sub(all(3.0F), hn::Mul(all(2.0F), t)));
}

HWY_INLINE Triples load(const float* numbers, std::size_t pitch) {
    const Reals d;
    return {hn::LoadU(d, numbers), hn::LoadU(d, numbers + pitch),
            hn::LoadU(d, numbers + 2 * pitch)};
}

HWY_INLINE void store(const Triples& t, float* numbers, std::size_t pitch) {
    const Reals d;
    hn::StoreU(t.x, d, numbers);
    hn::StoreU(t.y, d, numbers + pitch);
    hn::StoreU(t.z, d, numbers + 2 * pitch);
}

/// See marble_part; for the lanes from `first` on. False if the filter of some lane has no extent.
HWY_INLINE bool evaluate_lanes(const Field& field, const Marble& marble, FilterParts& parts,
                               std::size_t first) {
    const Reals d;
    constexpr std::size_t pitch = FilterParts::capacity;
    const Filters at{load(parts.position[0] + first, pitch), load(parts.across[0] + first, pitch),
                     load(parts.along[0] + first, pitch), hn::LoadU(d, parts.random + first)};
    const V one = all(1.0F);
    Triples color = all(marble.filler);
    if (marble.cloudiness > 0) {
        const V width = hn::Max(filter_width(marble.cloud_placement, at.across, at.along),
                                all(1.0F / float(1 << field.lattice->levels)));
        const V cloud =
            fluctuation_at(field, marble.cloud_placement, at.position, width, at.random).value;
        color = lerp(color, all(marble.cloud),
                     hn::Mul(all(marble.cloudiness), smooth(-1.2F, 1.2F, cloud)));
    }
    V clear = one;
    Triples slope = all(solid::triple(0, 0, 0));
    V least = one;
    for (int i = 0; i < marble.layers; ++i) {
        const VeinLayer& layer = marble.layer[i];
        Triples layer_slope;
        const V value = layer_value(field, layer, at, layer_slope, least);
        const V rest = hn::Sub(one, value);
        color = lerp(color, all(layer.color), hn::Mul(value, all(layer.strength)));
        slope = plus(scaled(slope, rest), scaled(layer_slope, clear));
        clear = hn::Mul(clear, rest);
    }
    const V value = hn::Sub(one, clear);
    store(color, parts.color[0] + first, pitch);
    store(scaled(slope, all(marble.depth)), parts.slope[0] + first, pitch);
    hn::StoreU(hn::Mul(all(marble.depth), value), d, parts.height + first);
    hn::StoreU(lerp(all(marble.filler_roughness), all(marble.vein_roughness), value), d,
               parts.roughness + first);
    hn::StoreU(value, d, parts.value + first);
    return hn::AllTrue(d, hn::Gt(least, hn::Zero(d)));
}

bool evaluate_marble(const Field& field, const Marble& marble, FilterParts& parts) {
    if (!in_lanes(field))
        return false;
    for (std::size_t i = 0; i < parts.count; i += hn::Lanes(Reals()))
        if (!evaluate_lanes(field, marble, parts, i))
            return false;
    return true;
}

#endif

} // namespace scree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scree {

HWY_EXPORT(evaluate_marble);

bool marble_in_lanes(const solid::Field& field, const solid::Marble& marble,
                     std::span<const ShadingPoint> points, std::span<ShadingSample> samples) {
    if (!marble.filtered || scalar_path_in_use())
        return false;
    return in_filter_parts(points, samples, [&](FilterParts& parts) {
        return HWY_DYNAMIC_DISPATCH(evaluate_marble)(field, marble, parts);
    });
}

} // namespace scree
#endif
