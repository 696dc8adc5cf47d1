// SPDX-License-Identifier: GPL-3.0-or-later
// The random bits and normal variates of nodes in vectors of any width. The operations are those of
// lattice.cl in the same order, so the results are bit-identical. For files compiled by Highway's
// foreach_target, which includes this again for every target.
#if defined(SCREE_NORMAL_VARIATES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SCREE_NORMAL_VARIATES_INL_H
#undef SCREE_NORMAL_VARIATES_INL_H
#else
#define SCREE_NORMAL_VARIATES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace scree::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// See scramble.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V scramble(D d, V h) {
    h = hn::Mul(hn::Xor(h, hn::ShiftRight<16>(h)), hn::Set(d, 0x7feb352dU));
    h = hn::Mul(hn::Xor(h, hn::ShiftRight<15>(h)), hn::Set(d, 0x846ca68bU));
    return hn::Xor(h, hn::ShiftRight<16>(h));
}

/// See node_bits; `place` is x * 0x9e3779b1 + row.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V node_bits(D d, V place, V other) {
    V h = hn::Mul(hn::Xor(place, hn::ShiftRight<16>(place)), hn::Set(d, 0x7feb352dU));
    h = hn::Mul(hn::Xor(hn::Xor(h, other), hn::ShiftRight<15>(h)), hn::Set(d, 0x846ca68bU));
    return hn::Xor(h, hn::ShiftRight<16>(h));
}

/// A polynomial by Horner's scheme, highest power first, without fused multiply-add.
template <class D, class V = hn::Vec<D>, class... Floats>
HWY_INLINE V polynomial(D d, V at, float first, Floats... others) {
    V sum = hn::Set(d, first);
    ((sum = hn::Add(hn::Mul(sum, at), hn::Set(d, others))), ...);
    return sum;
}

/// See plain_log.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V plain_log(D d, V v) {
    const hn::RebindToSigned<D> di;
    const auto bits = hn::BitCast(di, v);
    const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3f3504f3)));
    const V f =
        hn::Sub(hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent))), hn::Set(d, 1.0F));
    const V p = polynomial(d, f, 7.0376836292e-2F, -1.1514610310e-1F, 1.1676998740e-1F,
                           -1.2420140846e-1F, 1.4249322787e-1F, -1.6668057665e-1F, 2.0000714765e-1F,
                           -2.4999993993e-1F, 3.3333331174e-1F);
    const V e = hn::ConvertTo(d, exponent);
    const V squared = hn::Mul(f, f);
    V sum = hn::Mul(hn::Mul(f, squared), p);
    sum = hn::Sub(sum, hn::Mul(hn::Set(d, 2.12194440e-4F), e));
    sum = hn::Sub(sum, hn::Mul(hn::Set(d, 0.5F), squared));
    return hn::Add(hn::Add(sum, f), hn::Mul(hn::Set(d, 0.693359375F), e));
}

/// See normal_variate.
template <class D, class U = hn::Vec<hn::RebindToUnsigned<D>>>
HWY_INLINE hn::Vec<D> normal_variate(D d, U bits) {
    using V = hn::Vec<D>;
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const V one = hn::Set(d, 1.0F);
    const auto odd = hn::Or(hn::ShiftRight<7>(bits), hn::Set(du, 1U)); // (bits >> 8) * 2 + 1
    const V x = hn::Mul(hn::ConvertTo(d, hn::Sub(hn::BitCast(di, odd), hn::Set(di, 0x1000000))),
                        hn::Set(d, 0x1p-24F));
    const V w = hn::Neg(plain_log(d, hn::Mul(hn::Sub(one, x), hn::Add(one, x))));
    const V a = hn::Sub(w, hn::Set(d, 2.5F));
    V p = polynomial(d, a, 2.81022636e-08F, 3.43273939e-07F, -3.5233877e-06F, -4.39150654e-06F,
                     0.00021858087F, -0.00125372503F, -0.00417768164F, 0.246640727F, 1.50140941F);
    const auto usual = hn::Lt(w, hn::Set(d, 5.0F)); // all but 0.34%
    if (HWY_UNLIKELY(!hn::AllTrue(d, usual))) {
        const V b = hn::Sub(hn::Sqrt(w), hn::Set(d, 3.0F));
        const V q =
            polynomial(d, b, -0.000200214257F, 0.000100950558F, 0.00134934322F, -0.00367342844F,
                       0.00573950773F, -0.0076224613F, 0.00943887047F, 1.00167406F, 2.83297682F);
        p = hn::IfThenElse(usual, p, q);
    }
    return hn::Mul(hn::Mul(hn::Set(d, 1.41421356F), p), x);
}

} // namespace scree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
