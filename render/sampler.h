// SPDX-License-Identifier: GPL-3.0-or-later
// The points at which a pixel's integrand is sampled.
#pragma once

#include "core/math.h"

#include <cstdint>

namespace scree {

namespace sobol {

inline std::uint32_t reverse_bits(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = ((x & 0x0f0f0f0fU) << 4) | ((x >> 4) & 0x0f0f0f0fU);
    x = ((x & 0x33333333U) << 2) | ((x >> 2) & 0x33333333U);
    return ((x & 0x55555555U) << 1) | ((x >> 1) & 0x55555555U);
}

/// Owen scrambling by hashing, of a number whose bits are reversed: every bit is flipped by a hash
/// of those below it (Laine & Karras 2011 with the constants of Vegdahl 2021, "Building a better
/// LK hash").
inline std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeaU;
    x += seed;
    x *= (seed >> 16) | 1U;
    x ^= x * 0x05526c56U;
    x ^= x * 0x53a22864U;
    return x;
}

/// Product with Pascal's triangle modulo 2, the second Sobol matrix, by its Kronecker structure.
inline std::uint32_t pascal(std::uint32_t x) {
    x ^= x >> 16;
    x ^= (x & 0xff00ff00U) >> 8;
    x ^= (x & 0xf0f0f0f0U) >> 4;
    x ^= (x & 0xccccccccU) >> 2;
    return x ^ ((x & 0xaaaaaaaaU) >> 1);
}

inline std::uint32_t hash(std::uint32_t x) { // lowbias32 of Wellons 2018, "Hash prospector"
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    return x ^ (x >> 16);
}

inline std::uint32_t combine(std::uint32_t a, std::uint32_t b) {
    return hash(a ^ (b * 0x9e3779b9U + (a << 6) + (a >> 2)));
}

inline float to_unit(std::uint32_t x) { return static_cast<float>(x >> 8) * 0x1p-24F; }

} // namespace sobol

/// One sample of one pixel: a family of pairs of numbers in [0, 1)^2 by dimension. For each
/// dimension the pairs of the samples 0, 1, 2, ... of a pixel form a (0, 2)-sequence, the Sobol
/// points with Owen's scrambling in a shuffled order; dimensions and pixels are independent
/// (Burley 2020, "Practical hash-based Owen scrambling").
class Sampler {
  public:
    Sampler(std::uint64_t seed, int x, int y, std::uint32_t sample)
        : pixel_(
              sobol::combine(sobol::combine(sobol::combine(static_cast<std::uint32_t>(seed),
                                                           static_cast<std::uint32_t>(seed >> 32)),
                                            static_cast<std::uint32_t>(x)),
                             static_cast<std::uint32_t>(y))),
          reversed_sample_(sobol::reverse_bits(sample)) {}

    Vec2f pair(std::uint32_t dimension) const {
        const std::uint32_t key = sobol::combine(pixel_, dimension);
        const std::uint32_t index =
            sobol::reverse_bits(sobol::scramble_reversed(reversed_sample_, key));
        const std::uint32_t x = sobol::scramble_reversed(index, sobol::hash(key ^ 0x68bc21ebU));
        const std::uint32_t y =
            sobol::scramble_reversed(sobol::pascal(index), sobol::hash(key ^ 0x02e5be93U));
        return {sobol::to_unit(sobol::reverse_bits(x)), sobol::to_unit(sobol::reverse_bits(y))};
    }

    /// Key of a stream of random numbers, for what needs more of them than there are dimensions.
    std::uint64_t key() const { return (std::uint64_t{pixel_} << 32) | reversed_sample_; }

  private:
    std::uint32_t pixel_;
    std::uint32_t reversed_sample_;
};

/// Which dimension is used for what: fixed, so that the length of a path never shifts them.
namespace dimension {
inline constexpr std::uint32_t film = 0;
inline constexpr std::uint32_t lens = 1;
inline constexpr std::uint32_t first_bounce = 2;
inline constexpr std::uint32_t per_bounce = 4;
/// Added to a bounce where light leaves a translucent object, which scatters it once more.
inline constexpr std::uint32_t emerging = 1U << 16;
enum Use : std::uint32_t { direction, light, choice, roulette };
inline constexpr std::uint32_t at(std::uint32_t bounce, Use use) {
    return first_bounce + per_bounce * bounce + use;
}
} // namespace dimension

} // namespace scree
