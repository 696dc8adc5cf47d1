// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace scree {

/// Sorts the tasks 0, 1, ... into levels, so that those of a level may be done in any order or at
/// the same time, and all levels in turn give the outcome of all tasks in turn: no task depends on
/// another of its level, and each is in a later level than the earlier tasks that it depends on.
/// `neighbours[i]` are all tasks that depend on i or on which i depends.
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
