// SPDX-License-Identifier: GPL-3.0-or-later
// Four floats at a time, by the vector extension of GCC and Clang.
#pragma once

#include <cstdint>

namespace scree {

using Float4 = float __attribute__((vector_size(16)));
using Mask4 =
    std::int32_t __attribute__((vector_size(16))); // result of a comparison: 0 or -1 per lane

inline Float4 maximum(const Float4& a, const Float4& b) { return a > b ? a : b; }
inline Float4 minimum(const Float4& a, const Float4& b) { return a < b ? a : b; }

inline Float4 absolute(const Float4& v) {
    return reinterpret_cast<Float4>(reinterpret_cast<Mask4>(v) & (Mask4{} + 0x7FFFFFFF));
}

inline bool any(const Mask4& mask) {
    using Mask2 = std::int64_t __attribute__((vector_size(16)));
    const auto halves = reinterpret_cast<Mask2>(mask);
    return (halves[0] | halves[1]) != 0;
}

} // namespace scree
