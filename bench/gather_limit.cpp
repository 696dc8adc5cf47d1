// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/gather_limit.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace scree::bench {

namespace {

using Table = std::span<const float>;
using Places = std::span<const std::int32_t>;

void scalar_loads(Table table, Places first, const std::int32_t (&offsets)[8],
                  std::span<float> out) {
    for (std::size_t i = 0; i < out.size(); ++i) {
        float sum = 0;
        for (const std::int32_t offset : offsets)
            sum += table[static_cast<std::size_t>(first[i] + offset)];
        out[i] = sum;
    }
}

#if defined(__x86_64__)

[[gnu::target("avx2")]] void avx2(Table table, Places first, const std::int32_t (&offsets)[8],
                                  std::span<float> out) {
    for (std::size_t i = 0; i < out.size(); i += 8) {
        const __m256i at = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(first.data() + i));
        __m256 sum = _mm256_setzero_ps();
        for (const std::int32_t offset : offsets)
            sum = _mm256_add_ps(sum, _mm256_i32gather_ps(table.data() + offset, at, 4));
        _mm256_storeu_ps(out.data() + i, sum);
    }
}

[[gnu::target("avx512f")]] void avx512(Table table, Places first, const std::int32_t (&offsets)[8],
                                       std::span<float> out) {
    for (std::size_t i = 0; i < out.size(); i += 16) {
        const __m512i at = _mm512_loadu_si512(first.data() + i);
        __m512 sum = _mm512_setzero_ps();
        for (const std::int32_t offset : offsets)
            sum = _mm512_add_ps(sum, _mm512_i32gather_ps(at, table.data() + offset, 4));
        _mm512_storeu_ps(out.data() + i, sum);
    }
}

#endif

} // namespace

std::vector<Gather> gathers() {
    std::vector<Gather> found;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
        found.push_back({"AVX-512 gathers", avx512});
    if (__builtin_cpu_supports("avx2"))
        found.push_back({"AVX2 gathers", avx2});
#endif
    found.push_back({"scalar loads", scalar_loads});
    return found;
}

} // namespace scree::bench
