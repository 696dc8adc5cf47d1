// SPDX-License-Identifier: GPL-3.0-or-later
// The points at which a pixel's integrand is sampled.
#pragma once

#include "render/sobol.h"

#include <cstdint>

namespace scree {

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

/// One sample of one pixel: a family of pairs of numbers in [0, 1)^2 by dimension. Places on the
/// film and the directions and light samples of the first bounces are coordinates of one Sobol
/// sequence: what a pixel's light depends on most is stratified jointly. For each other dimension
/// the pairs of the samples 0, 1, 2, ... of a pixel form a (0, 2)-sequence of their own, in a
/// shuffled order. All have Owen's scrambling, and pixels are independent (Burley 2020, "Practical
/// hash-based Owen scrambling").
class Sampler {
  public:
    Sampler(std::uint64_t seed, int x, int y, std::uint32_t sample)
        : pixel_(
              sobol::combine(sobol::combine(sobol::combine(static_cast<std::uint32_t>(seed),
                                                           static_cast<std::uint32_t>(seed >> 32)),
                                            static_cast<std::uint32_t>(x)),
                             static_cast<std::uint32_t>(y))),
          sample_(sample) {}

    Vec2f pair(std::uint32_t dimension) const {
        const std::uint32_t key = sobol::combine(pixel_, dimension);
        const std::size_t joint = joint_coordinate(dimension);
        const auto [x, y] = joint < sobol::dimensions ? sobol::pair(sample_, joint)
                                                      : sobol::first_pair(shuffled(key));
        return {sobol::to_unit(sobol::scramble_reversed(x, sobol::hash(key ^ 0x68bc21ebU))),
                sobol::to_unit(sobol::scramble_reversed(y, sobol::hash(key ^ 0x02e5be93U)))};
    }

    /// Key of a stream of random numbers, for what needs more of them than there are dimensions.
    std::uint64_t key() const { return (std::uint64_t{pixel_} << 32) | sample_; }

  private:
    /// Which coordinate of the joint sequence a dimension's pair begins at; beyond them: none.
    static std::size_t joint_coordinate(std::uint32_t dimension) {
        if (dimension == dimension::film)
            return 0;
        const std::uint32_t bounce = (dimension - dimension::first_bounce) / dimension::per_bounce;
        const std::uint32_t use = (dimension - dimension::first_bounce) % dimension::per_bounce;
        return dimension >= dimension::first_bounce && use <= dimension::light
                   ? 2 + 4 * std::size_t{bounce} + 2 * std::size_t{use}
                   : sobol::dimensions;
    }
    std::uint32_t shuffled(std::uint32_t key) const {
        return sobol::reverse_bits(sobol::scramble_reversed(sobol::reverse_bits(sample_), key));
    }

    std::uint32_t pixel_;
    std::uint32_t sample_;
};

} // namespace scree
