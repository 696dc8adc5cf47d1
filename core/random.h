// SPDX-License-Identifier: GPL-3.0-or-later
// Counter-based random numbers: the same bytes on any number of threads.
#pragma once

#include <Random123/philox.h>

#include <bit>
#include <cstdint>
#include <numbers>

namespace scree {

/// What a stream is used for, so that two uses of one seed never share numbers. Renumbering would
/// change the output: append only.
enum class Purpose : std::uint32_t {
    layout_dart = 1,
    layout_sparse = 2,
    layout_candidate = 3,
    layout_choice = 4,
    instance_attribute = 5,
    mesh_shape = 6,
    pixel_sample = 7,
    test = 8,
    layout_saturate = 9,
    analysis_sample = 32,
    layout_order = 10,
    leather_cell = 40,
    leather_outline = 41,
    leather_height = 42,
    leather_noise = 43,
    leather_pore = 44,
    disk_dart = 45,
    disk_class = 46,
    element_attribute = 47,
    disk_start = 48,
    solid_lattice = 49,
    solid_place = 50,
    solid_vein = 51,
    solid_ring = 52,
    solid_knot = 53,
    solid_cell = 54,
    pile_order = 60,
    pile_turn = 61,
    pile_ray = 62,
    pile_inside = 63,
    pile_strew = 64,
    pile_shape = 66,
    pile_choice = 67,
    pile_sites = 72,
    pile_shell = 73,
    pile_fill = 74,
    subsurface_walk = 68,
    rock_shape = 80,
    rock_kind = 81,
    rock_size = 82,
    rock_place = 83,
    rock_cell = 84,
    rock_tile = 85,
    fibre_shape = 90,
    fibre_place = 91,
    fibre_root = 92,
    fibre_attribute = 93,
    shard_order = 100,
};

/// A stream of uniform random numbers keyed by (seed, purpose, index): Philox 4x32-10 (Salmon et
/// al. 2011). A number is a pure function of the key and its position in the stream, so streams may
/// be created in any order on any thread.
class Random {
  public:
    Random(std::uint64_t seed, Purpose purpose, std::uint64_t index = 0)
        : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
          counter_{{0, static_cast<std::uint32_t>(purpose), static_cast<std::uint32_t>(index),
                    static_cast<std::uint32_t>(index >> 32)}} {}

    std::uint32_t bits() {
        if (used_ == 4) {
            block_ = r123::Philox4x32()(counter_, key_);
            ++counter_.v[0];
            used_ = 0;
        }
        return block_.v[used_++];
    }

    /// Uniform in [0, 1), 24 bits.
    float uniform_float() { return static_cast<float>(bits() >> 8) * 0x1p-24F; }

    /// Uniform in [0, 1), 53 bits.
    double uniform() {
        const std::uint64_t high = bits() >> 5;
        const std::uint64_t low = bits() >> 6;
        return static_cast<double>((high << 26) | low) * 0x1p-53;
    }

    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Exponentially distributed with mean 1, 32 bits. The logarithm is computed here, since the
    /// last bit of std::log differs between C libraries: an odd series in (m - 1) / (m + 1) for the
    /// mantissa m in [sqrt(1/2), sqrt(2)), with a truncation error below 1e-8.
    double exponential() {
        const double u = (bits() + 0.5) * 0x1p-32;
        const auto pattern = std::bit_cast<std::uint64_t>(u);
        auto exponent = static_cast<int>(pattern >> 52) - 1023;
        double m = std::bit_cast<double>((pattern & 0xFFFFFFFFFFFFFU) | 0x3FF0000000000000U);
        if (m > std::numbers::sqrt2) {
            m *= 0.5;
            ++exponent;
        }
        const double s = (m - 1) / (m + 1);
        const double s2 = s * s;
        const double series =
            s * (2 + s2 * (2.0 / 3 + s2 * (2.0 / 5 + s2 * (2.0 / 7 + s2 * (2.0 / 9)))));
        return -(exponent * std::numbers::ln2 + series);
    }

    /// A uniform integer in [0, n), n >= 1, without modulo bias (Lemire 2019).
    std::uint32_t below(std::uint32_t n) {
        std::uint64_t product = std::uint64_t{bits()} * n;
        if (static_cast<std::uint32_t>(product) < n) {
            const std::uint32_t threshold = (0U - n) % n;
            while (static_cast<std::uint32_t>(product) < threshold)
                product = std::uint64_t{bits()} * n;
        }
        return static_cast<std::uint32_t>(product >> 32);
    }

    /// Uniform in [0, 2^64).
    std::uint64_t bits64() {
        const std::uint64_t high = bits();
        return high << 32 | bits();
    }

  private:
    r123::Philox4x32::key_type key_;
    r123::Philox4x32::ctr_type counter_;
    r123::Philox4x32::ctr_type block_{};
    unsigned used_ = 4;
};

/// A seed of its own for each (seed, purpose, index), for what draws its random numbers from a
/// seed. Unlike sums of a seed and a number, seeds derived so do not meet those of other uses.
inline std::uint64_t derived_seed(std::uint64_t seed, Purpose purpose, std::uint64_t index) {
    return Random(seed, purpose, index).bits64();
}

} // namespace scree
