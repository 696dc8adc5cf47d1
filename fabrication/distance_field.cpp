// SPDX-License-Identifier: GPL-3.0-or-later
#include "fabrication/distance_field.h"

#include "core/parallel.h"

#include <algorithm>

namespace scree {

bool DistanceField::unite(std::uint64_t key, const Values& values) {
    Shard& shard = shard_of(key);
    const std::scoped_lock lock(shard.mutex);
    const auto [found, is_new] = shard.blocks.try_emplace(key);
    if (is_new) {
        if (++held_ > most_blocks_)
            return false;
        found->second = std::make_unique<Values>(values);
    } else if (found->second) {
        Values& held = *found->second;
        for (std::size_t i = 0; i < held.size(); ++i)
            held[i] = std::min(held[i], values[i]);
    }
    return true;
}

void DistanceField::unite_inside(std::uint64_t key) {
    Shard& shard = shard_of(key);
    const std::scoped_lock lock(shard.mutex);
    const auto [found, is_new] = shard.blocks.try_emplace(key);
    if (!is_new && found->second) {
        found->second.reset();
        --held_;
    }
}

std::vector<DistanceField::Block> DistanceField::blocks() const {
    std::vector<Block> out;
    for (const Shard& shard : shards_)
        for (const auto& [key, values] : shard.blocks)
            out.push_back({key, values.get()});
    parallel_sort(out.begin(), out.end(),
                  [](const Block& a, const Block& b) { return a.key < b.key; });
    return out;
}

} // namespace scree
