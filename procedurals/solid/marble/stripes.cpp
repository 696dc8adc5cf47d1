// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/marble/stripes.h"

#include <algorithm>
#include <array>

namespace scree {

namespace {

// Points per block, so that their fluctuations stay in the L1 cache until they are used.
constexpr std::size_t block = 1024;

/// Calls work(first, fluctuations) block by block.
void in_blocks(const LatticeQuads& quads, std::span<const float> x, std::span<const float> y,
               std::span<const float> z, const auto& work) {
    std::array<float, block> memory;
    for (std::size_t first = 0; first < x.size(); first += block) {
        const std::size_t count = std::min(block, x.size() - first);
        const std::span<float> found(memory.data(), count);
        quads.fluctuations(x.subspan(first, count), y.subspan(first, count),
                           z.subspan(first, count), found);
        work(first, std::span<const float>(found));
    }
}

} // namespace

void marble_values(const LatticeQuads& quads, const VeinTable& veins, float displacement,
                   std::span<const float> x, std::span<const float> y, std::span<const float> z,
                   std::span<float> out) {
    in_blocks(quads, x, y, z, [&](std::size_t first, std::span<const float> d) {
        veins.values(z.subspan(first, d.size()), d, displacement, out.subspan(first, d.size()));
    });
}

void wood_values(const LatticeQuads& quads, const PlainWood& wood, std::span<const float> x,
                 std::span<const float> y, std::span<const float> z, std::span<float> out) {
    in_blocks(quads, x, y, z, [&](std::size_t first, std::span<const float> d) {
        ring_values(wood, x.subspan(first, d.size()), y.subspan(first, d.size()), d,
                    out.subspan(first, d.size()));
    });
}

} // namespace scree
