// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace scree::bench {

/// One way in which this machine can load 32-bit words from eight places of a table per sample.
struct Gather {
    std::string name;
    /// Computes the sum of table[first + offset] over the eight offsets for every sample. Lengths
    /// are multiples of 16.
    void (*run)(std::span<const float> table, std::span<const std::int32_t> first,
                const std::int32_t (&offsets)[8], std::span<float> out);
};

/// All ways that this machine supports; scalar loads are the last.
std::vector<Gather> gathers();

} // namespace scree::bench
