// SPDX-License-Identifier: GPL-3.0-or-later
// Loads a record of four adjacent words for every lane: one load of 16 bytes per lane and a
// transposition instead of four gathers. For files compiled by Highway's foreach_target, which
// includes this again for every target.
#if defined(SCREE_RECORDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SCREE_RECORDS_INL_H
#undef SCREE_RECORDS_INL_H
#else
#define SCREE_RECORDS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace scree::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

#if HWY_HAVE_SCALABLE
using Reals = hn::CappedTag<float, 4>;
#else
using Reals = hn::ScalableTag<float>;
#endif
using Words = hn::RebindToUnsigned<Reals>;

/// For each block of 4 lanes, 16 bytes of the table at the place given by its first lane.
template <class D>
HWY_INLINE hn::Vec<D> load_blocks(D d, const std::uint8_t* table, const std::uint32_t* places) {
    const hn::Repartition<std::uint8_t, D> bytes;
    const auto block = [&](std::size_t i) {
        return hn::BitCast(d, hn::LoadDup128(bytes, table + 8 * std::size_t(places[4 * i])));
    };
    const auto lane = hn::Iota(d, 0);
    auto blocks = block(0);
    for (std::size_t i = 1; i < hn::Lanes(d) / 4; ++i) {
        const auto from_here = hn::Gt(lane, hn::Set(d, static_cast<std::uint32_t>(4 * i - 1)));
        blocks = hn::IfThenElse(from_here, block(i), blocks);
    }
    return blocks;
}

struct Records {
    hn::Vec<Words> first, second, third, fourth;
};

/// Records of 16 bytes, one per lane, at places of a table in units of 8 bytes. The places should
/// have been stored to memory some time before, since they are read one by one and a vector store
/// immediately before would stall these loads.
HWY_INLINE Records load_records(const void* table, const std::uint32_t* places) {
    const Words du;
    const hn::RepartitionToWide<Words> dw;
    const auto* bytes = static_cast<const std::uint8_t*>(table);
    // The record of lane 4 j + i is the j-th block of the i-th of these vectors.
    const auto v0 = load_blocks(du, bytes, places);
    const auto v1 = load_blocks(du, bytes, places + 1);
    const auto v2 = load_blocks(du, bytes, places + 2);
    const auto v3 = load_blocks(du, bytes, places + 3);
    const auto low01 = hn::BitCast(dw, hn::InterleaveLower(du, v0, v1));
    const auto low23 = hn::BitCast(dw, hn::InterleaveLower(du, v2, v3));
    const auto high01 = hn::BitCast(dw, hn::InterleaveUpper(du, v0, v1));
    const auto high23 = hn::BitCast(dw, hn::InterleaveUpper(du, v2, v3));
    return {hn::BitCast(du, hn::InterleaveLower(dw, low01, low23)),
            hn::BitCast(du, hn::InterleaveUpper(dw, low01, low23)),
            hn::BitCast(du, hn::InterleaveLower(dw, high01, high23)),
            hn::BitCast(du, hn::InterleaveUpper(dw, high01, high23))};
}

#endif

} // namespace scree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
