// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <vector>

namespace scree {

/// A point of a cubic lattice.
struct LatticePoint {
    int x = 0;
    int y = 0;
    int z = 0;

    friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// A signed distance to the surface of a solid, negative inside, sampled on the points of a cubic
/// lattice, in units of the lattice. Stored sparsely, near the surface only, in blocks of 8 x 8 x 8
/// points.
class DistanceField {
  public:
    static constexpr int side = 8;
    static constexpr int samples = side * side * side;
    static constexpr int limit = 1 << 19; // of the absolute values of a block's coordinates
    using Values = std::array<float, samples>;

    /// A block: the values of its points, or null when it lies deeper inside than `inner`.
    struct Block {
        std::uint64_t key = 0;
        const Values* values = nullptr;
    };

    /// Distances are clamped to [-inner, outer]. Both must be at least 1.75, slightly more than the
    /// diagonal of a cell. At most `most_blocks` blocks may have values.
    DistanceField(float inner, float outer, std::size_t most_blocks)
        : inner_(inner), outer_(outer), most_blocks_(most_blocks) {}

    float inner() const { return inner_; }
    float outer() const { return outer_; }

    /// The key of a block, whose coordinates are in units of 8 points. Keys are ordered by z, then
    /// y, then x.
    static std::uint64_t key_of(const LatticePoint& block) {
        return std::uint64_t(block.z + limit) << 40 | std::uint64_t(block.y + limit) << 20 |
               std::uint64_t(block.x + limit);
    }
    static LatticePoint block_of(std::uint64_t key) {
        return {int(key & 0xfffff) - limit, int(key >> 20 & 0xfffff) - limit,
                int(key >> 40) - limit};
    }
    static int sample(int x, int y, int z) { return (z * side + y) * side + x; }

    /// The union with another solid: takes the minimum of the stored and the given values.
    /// Thread-safe and independent of order. False when there are too many blocks.
    bool unite(std::uint64_t key, const Values& values);

    /// The same for a block that lies entirely inside another solid, deeper than `inner`.
    void unite_inside(std::uint64_t key);

    /// All blocks that are not entirely outside, sorted by key. Invalidated by further unions.
    std::vector<Block> blocks() const;

  private:
    struct Shard {
        std::mutex mutex;
        std::unordered_map<std::uint64_t, std::unique_ptr<Values>> blocks; // null: inside
    };
    Shard& shard_of(std::uint64_t key) { return shards_[key * 0x9e3779b97f4a7c15ULL >> 56]; }

    float inner_;
    float outer_;
    std::size_t most_blocks_;
    std::atomic<std::size_t> held_ = 0;
    std::array<Shard, 256> shards_;
};

} // namespace scree
