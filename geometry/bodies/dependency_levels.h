// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace scree {

/// Numbers 0, 1, ... in levels such that none depends on another of its level, and each stands in
/// a later level than those before it that it depends on: worked through level by level, each
/// level in any order, the outcome is that of strict order. `neighbours[i]` lists whom i depends
/// on, both ways.
inline std::vector<std::vector<std::uint32_t>>
dependency_levels(std::span<const std::vector<std::uint32_t>> neighbours) {
    std::vector<std::uint32_t> level(neighbours.size(), 0);
    std::vector<std::vector<std::uint32_t>> levels;
    for (std::uint32_t i = 0; i < neighbours.size(); ++i) {
        for (const std::uint32_t j : neighbours[i])
            if (j < i && level[j] >= level[i])
                level[i] = level[j] + 1;
        if (level[i] >= levels.size())
            levels.resize(level[i] + 1);
        levels[level[i]].push_back(i);
    }
    return levels;
}

} // namespace scree
