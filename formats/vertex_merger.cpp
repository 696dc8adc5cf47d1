// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/vertex_merger.h"

#include <bit>

namespace scree {

std::uint32_t VertexMerger::add(const Imath::V3d& position) {
    std::array<std::uint64_t, 3> bits{};
    for (int axis = 0; axis < 3; ++axis) // adding 0 makes 0 of -0
        bits[std::size_t(axis)] = std::bit_cast<std::uint64_t>(position[axis] + 0.0);
    const auto [entry, added] =
        known_.try_emplace(bits, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (added)
        mesh_.positions.push_back(position);
    return entry->second;
}

} // namespace scree
