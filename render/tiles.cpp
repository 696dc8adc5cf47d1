// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tiles.h"

#include "core/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace scree {

namespace {

constexpr int side = 16; // pixels; 256 pixels keep a thread busy for milliseconds

// Every run of `count` tiles, in the order of rows, holds one of each shard, in a random order: a
// regular pattern could coincide with one of the picture.
std::vector<int> shards_of(std::size_t tiles, int count) {
    std::vector<int> shards(tiles);
    std::vector<int> order(static_cast<std::size_t>(count));
    for (std::size_t first = 0; first < tiles; first += order.size()) {
        Random random(0, Purpose::shard_order, first);
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t i = order.size(); i > 1; --i)
            std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
        std::copy_n(order.begin(), std::min(order.size(), tiles - first), &shards[first]);
    }
    return shards;
}

constexpr int most_shards = 65536;

} // namespace

std::optional<Shard> parse_shard(const std::string& text) {
    int number = 0;
    int count = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%d/%d%c", &number, &count, &rest) != 2 || number < 1 ||
        number > count || count > most_shards)
        return {};
    return Shard{number - 1, count};
}

std::string shard_text(const Shard& shard) {
    return fmt::format("{}/{}", shard.index + 1, shard.count);
}

std::vector<Tile> shard_tiles(int width, int height, const Shard& shard) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += side)
        for (int x = 0; x < width; x += side)
            tiles.push_back({x, y, std::min(x + side, width), std::min(y + side, height)});
    const std::vector<int> shards = shards_of(tiles.size(), shard.count);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < tiles.size(); ++i)
        if (shards[i] == shard.index)
            tiles[kept++] = tiles[i];
    tiles.resize(kept);
    return tiles;
}

} // namespace scree
