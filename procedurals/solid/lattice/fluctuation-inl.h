// SPDX-License-Identifier: GPL-3.0-or-later
// The fractal field at several points, one in each lane, each with its own filter. The operations
// are those of lattice.cl in the same order, so the results are bit-identical. For files compiled
// by Highway's foreach_target, which includes this again for every target.
#if defined(SCREE_FLUCTUATION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SCREE_FLUCTUATION_INL_H
#undef SCREE_FLUCTUATION_INL_H
#else
#define SCREE_FLUCTUATION_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace scree::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

using Reals = hn::CappedTag<float, 8>;
using Ints = hn::RebindToSigned<Reals>;
using V = hn::Vec<Reals>;
using I = hn::Vec<Ints>;
using Mask = hn::Mask<Reals>;

HWY_INLINE V all(float v) { return hn::Set(Reals(), v); }
HWY_INLINE I all(int v) { return hn::Set(Ints(), v); }
HWY_INLINE V chosen(Mask mask, V yes, V no) { return hn::IfThenElse(mask, yes, no); }
HWY_INLINE bool any(Mask mask) { return !hn::AllFalse(Reals(), mask); }
HWY_INLINE V real(I v) { return hn::ConvertTo(Reals(), v); }
HWY_INLINE V gathered(const float* table, I index) {
    return hn::GatherIndex(Reals(), table, index);
}

/// a + (b - a) share.
HWY_INLINE V lerp(V a, V b, V share) { return hn::Add(a, hn::Mul(hn::Sub(b, a), share)); }

/// v clamped to [low, high].
HWY_INLINE V clamped(V v, float low, float high) {
    return hn::Min(hn::Max(v, all(low)), all(high));
}

struct Triples {
    V x, y, z;
};

HWY_INLINE Triples all(const solid::Triple& t) { return {all(t.x), all(t.y), all(t.z)}; }
HWY_INLINE Triples plus(const Triples& a, const Triples& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Triples minus(const Triples& a, const Triples& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Triples scaled(const Triples& a, V s) {
    return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE V dot3(const Triples& a, const Triples& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Triples chosen(Mask mask, const Triples& yes, const Triples& no) {
    return {chosen(mask, yes.x, no.x), chosen(mask, yes.y, no.y), chosen(mask, yes.z, no.z)};
}
HWY_INLINE Triples multiply(const solid::Triple* rows, const Triples& v) {
    return {dot3(all(rows[0]), v), dot3(all(rows[1]), v), dot3(all(rows[2]), v)};
}
HWY_INLINE Triples multiply_transposed(const solid::Triple* rows, const Triples& v) {
    return plus(plus(scaled(all(rows[0]), v.x), scaled(all(rows[1]), v.y)),
                scaled(all(rows[2]), v.z));
}

struct Fluctuations {
    V value;
    Triples gradient;
    V variance;
};

/// 16-bit nodes of complete levels: those of the lattice or of the tile.
struct Nodes {
    const std::int16_t* first;
    int levels;
    float step;
};

/// See nodes_field; with one level per lane.
HWY_INLINE Fluctuations nodes_field(const Nodes& nodes, I level, const Triples& p) {
    const Reals d;
    const Ints di;
    const V cells = hn::BitCast(d, hn::ShiftLeft<23>(hn::Add(level, all(127))));
    const Triples at = scaled(p, cells);
    const Triples cell{hn::Floor(at.x), hn::Floor(at.y), hn::Floor(at.z)};
    const Triples in = minus(at, cell);
    const I mask = hn::Sub(hn::Shl(all(1), level), all(1));
    const I stride = hn::Shl(all(1), hn::Sub(all(nodes.levels), level));
    const I side = all((1 << nodes.levels) + 1);
    const auto number = [&](V v) { return hn::And(hn::ConvertTo(di, v), mask); };
    I node = hn::Add(number(cell.y), hn::Mul(side, number(cell.z)));
    node = hn::Mul(stride, hn::Add(number(cell.x), hn::Mul(side, node)));
    // Loads two adjacent nodes as one word of 32 bits.
    const auto pair_at = [&](I place) {
        return hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(nodes.first),
                                hn::Add(place, place));
    };
    const V step = all(nodes.step);
    const auto value = [&](I word) { return hn::Mul(step, real(word)); };
    const auto low = [](I word) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(word)); };
    const I y = hn::Mul(stride, side), z = hn::Mul(y, side);
    const I corners[4] = {node, hn::Add(node, y), hn::Add(node, z), hn::Add(hn::Add(node, z), y)};
    V near_x[4], far_x[4];
    const bool neighbours = hn::AllTrue(di, hn::Eq(stride, all(1)));
    for (int i = 0; i < 4; ++i) {
        const I both = pair_at(corners[i]);
        near_x[i] = value(low(both));
        far_x[i] = value(neighbours ? hn::ShiftRight<16>(both)
                                    : low(pair_at(hn::Add(corners[i], stride))));
    }
    const auto across = [&](int i) { return lerp(near_x[i], far_x[i], in.x); };
    const auto rise = [&](int i) { return hn::Sub(far_x[i], near_x[i]); };
    const V a = across(0), b = across(1), c = across(2), e = across(3);
    const V near = lerp(a, b, in.y), far = lerp(c, e, in.y);
    const V dx_near = lerp(rise(0), rise(1), in.y), dx_far = lerp(rise(2), rise(3), in.y);
    const Triples slope{lerp(dx_near, dx_far, in.z), lerp(hn::Sub(b, a), hn::Sub(e, c), in.z),
                        hn::Sub(far, near)};
    return {lerp(near, far, in.z), scaled(slope, cells), all(0.0F)};
}

/// See rough_log2.
HWY_INLINE V rough_log2(V v) {
    const Reals d;
    const I bits = hn::BitCast(Ints(), v);
    const V one_to_two = hn::BitCast(d, hn::Or(hn::And(bits, all(0x7fffff)), all(0x3f800000)));
    const V t = hn::Sub(one_to_two, all(1.0F));
    const V exponent = real(hn::Sub(hn::ShiftRight<23>(bits), all(127)));
    return hn::Add(hn::Add(exponent, t), hn::Mul(hn::Mul(all(0.3437F), t), hn::Sub(all(1.0F), t)));
}

/// See resolved_level.
HWY_INLINE V resolved_level(const solid::Lattice& lattice, V width) {
    const auto finest = static_cast<float>(lattice.finest);
    const V level = chosen(hn::Gt(width, all(0.0F)),
                           clamped(hn::Sub(all(0.5F), rough_log2(width)), 0, finest), all(finest));
    return chosen(hn::Lt(level, all(static_cast<float>(lattice.unique_levels))), level,
                  hn::Floor(hn::Add(level, all(0.5F))));
}

/// Whether `fluctuation` below supports the lattice: it must be periodic, have 16-bit nodes and
/// store all its unique levels.
HWY_INLINE bool in_lanes(const solid::Field& field) {
    const solid::Lattice& lattice = *field.lattice;
    return std::endian::native == std::endian::little && lattice.step > 0 && lattice.repeats != 0 &&
           lattice.levels == lattice.unique_levels;
}

/// See add_tile.
HWY_INLINE void add_tile(const solid::Field& field, I last, const Triples& p, Fluctuations& sum) {
    const solid::Lattice& lattice = *field.lattice;
    const Nodes tile{field.nodes16 + lattice.tile, TILE_COARSE + TILE_LEVELS, lattice.tile_step};
    auto scale = static_cast<float>(1 << (lattice.unique_levels - TILE_COARSE));
    for (int base = lattice.unique_levels; base < lattice.finest;
         base += TILE_LEVELS, scale *= static_cast<float>(1 << TILE_LEVELS)) {
        const I more = hn::Sub(last, all(base));
        const Mask finer = hn::RebindMask(Reals(), hn::Gt(more, all(0)));
        if (!any(finer))
            return;
        const I levels =
            hn::Add(all(TILE_COARSE), hn::Max(hn::Min(more, all(TILE_LEVELS)), all(0)));
        const Fluctuations found = nodes_field(tile, levels, scaled(p, all(scale)));
        const float amplitude = lattice.amplitude[base + 1];
        sum.value =
            chosen(finer, hn::Add(sum.value, hn::Mul(found.value, all(amplitude))), sum.value);
        sum.gradient =
            chosen(finer, plus(sum.gradient, scaled(found.gradient, all(amplitude * scale))),
                   sum.gradient);
    }
}

/// See fluctuation; for a lattice that is in_lanes.
HWY_INLINE Fluctuations fluctuation(const solid::Field& field, Triples p, V width) {
    const solid::Lattice& lattice = *field.lattice;
    const V resolved = resolved_level(lattice, width);
    p = minus(p, {hn::Floor(p.x), hn::Floor(p.y), hn::Floor(p.z)});
    const I whole = hn::ConvertTo(Ints(), resolved);
    const V share = hn::Sub(resolved, real(whole));
    const Nodes stored{field.nodes16, lattice.levels, lattice.step};
    Fluctuations sum = nodes_field(stored, hn::Min(whole, all(lattice.levels)), p);
    const Mask between = hn::And(hn::Gt(share, all(0.0F)),
                                 hn::RebindMask(Reals(), hn::Lt(whole, all(lattice.levels))));
    if (any(between)) {
        const I next = hn::Min(hn::Add(whole, all(1)), all(lattice.levels));
        const Fluctuations finer = nodes_field(stored, next, p);
        sum.value = chosen(between, lerp(sum.value, finer.value, share), sum.value);
        sum.gradient = chosen(
            between,
            plus(scaled(sum.gradient, hn::Sub(all(1.0F), share)), scaled(finer.gradient, share)),
            sum.gradient);
    }
    add_tile(field, whole, p, sum);
    const V next = gathered(lattice.amplitude, hn::Add(whole, all(1)));
    V taken = hn::Mul(hn::Mul(hn::Mul(share, share), next), next);
    taken = hn::Mul(taken, all(lattice.mean_square));
    sum.variance = hn::Sub(gathered(lattice.residual_variance, whole), taken);
    return sum;
}

/// See filter_width.
HWY_INLINE V filter_width(const solid::Placement& placement, const Triples& across,
                          const Triples& along) {
    const auto length = [](const Triples& v) { return hn::Sqrt(dot3(v, v)); };
    return hn::Max(length(multiply(placement.rows, across)),
                   length(multiply(placement.rows, along)));
}

/// See fluctuation_at.
HWY_INLINE Fluctuations fluctuation_at(const solid::Field& field, const solid::Placement& placement,
                                       const Triples& position, V width, V random) {
    Triples place = plus(multiply(placement.rows, position), all(placement.offset));
    if (placement.vary > 0)
        place = plus(place, {hn::Mul(random, all(47.31F)), hn::Mul(random, all(23.17F)),
                             hn::Mul(random, all(91.73F))});
    Fluctuations found = fluctuation(field, place, width);
    found.gradient = multiply_transposed(placement.rows, found.gradient);
    return found;
}

#endif

} // namespace scree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
