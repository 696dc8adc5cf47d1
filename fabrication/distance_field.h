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

/// Samples on the points of a cubic lattice of a distance to a solid's surface, negative inside, in
/// units of the lattice; kept near the surface only, in blocks of 8 x 8 x 8 points.
class DistanceField {
  public:
    static constexpr int side = 8;
    static constexpr int samples = side * side * side;
    static constexpr int limit = 1 << 19; // of a block's coordinates, either way
    using Values = std::array<float, samples>;

    /// What is known about a block: the values of its points, or that it lies too deep inside to
    /// have any.
    struct Block {
        std::uint64_t key = 0;
        const Values* values = nullptr;
    };

    /// Distances are cut off at -inner and outer, at least 1.75 each, more than the diagonal of a
    /// cell. No more than `most_blocks` may hold values.
    DistanceField(float inner, float outer, std::size_t most_blocks)
        : inner_(inner), outer_(outer), most_blocks_(most_blocks) {}

    float inner() const { return inner_; }
    float outer() const { return outer_; }

    /// Identifies a block by its place, in units of 8 points; sorted by z, then y, then x.
    static std::uint64_t key_of(const LatticePoint& block) {
        return std::uint64_t(block.z + limit) << 40 | std::uint64_t(block.y + limit) << 20 |
               std::uint64_t(block.x + limit);
    }
    static LatticePoint block_of(std::uint64_t key) {
        return {int(key & 0xfffff) - limit, int(key >> 20 & 0xfffff) - limit,
                int(key >> 40) - limit};
    }
    static int sample(int x, int y, int z) { return (z * side + y) * side + x; }

    /// Takes the smaller of the values there and those given: the union with another solid. From
    /// any number of threads at once, in any order. False: there is no room for the block.
    bool unite(std::uint64_t key, const Values& values);

    /// The same for a block that lies wholly inside another solid, deeper than `inner`.
    void unite_inside(std::uint64_t key);

    /// All blocks that are not wholly outside, sorted by key; while nothing is added.
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
