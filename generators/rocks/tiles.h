// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace scree::rocks {

/// A box in square tiles, each with the numbers of the rocks in it. Tiles of one colour have at
/// least one tile between them.
class Tiles {
  public:
    static constexpr int colours = 4;

    Tiles(const Box2& box, double side)
        : low_(box.min), side_(side), width_(1 + static_cast<int>(box.size().x / side)),
          depth_(1 + static_cast<int>(box.size().y / side)),
          members_(std::size_t(width_) * std::size_t(depth_)) {}

    std::size_t count() const { return members_.size(); }
    /// The tile of a place; of one outside of the box the nearest.
    std::size_t at(const Vec2& place) const {
        return index(column(place.x, low_.x, width_), column(place.y, low_.y, depth_));
    }
    Box2 box(std::size_t tile) const {
        const std::size_t row = tile / std::size_t(width_);
        const std::size_t column = tile % std::size_t(width_);
        const Vec2 low = low_ + Vec2(double(column), double(row)) * side_;
        return {low, low + Vec2(side_)};
    }
    std::vector<std::uint32_t> of_colour(int colour) const {
        std::vector<std::uint32_t> tiles;
        for (int j = colour / 2; j < depth_; j += 2)
            for (int i = colour % 2; i < width_; i += 2)
                tiles.push_back(static_cast<std::uint32_t>(index(i, j)));
        return tiles;
    }
    void add(std::size_t tile, std::uint32_t number) { members_[tile].push_back(number); }

    /// Calls found(number) for all rocks in a tile and in those around it.
    template <class Found>
    void each_near(std::size_t tile, const Found& found) const {
        const int x = static_cast<int>(tile % std::size_t(width_));
        const int z = static_cast<int>(tile / std::size_t(width_));
        for (int j = std::max(z - 1, 0); j <= std::min(z + 1, depth_ - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width_ - 1); ++i)
                for (const std::uint32_t number : members_[index(i, j)])
                    found(number);
    }

  private:
    int column(double x, double low, int count) const {
        return std::clamp(static_cast<int>(std::floor((x - low) / side_)), 0, count - 1);
    }
    std::size_t index(int i, int j) const {
        return std::size_t(j) * std::size_t(width_) + std::size_t(i);
    }

    Vec2 low_;
    double side_;
    int width_;
    int depth_;
    std::vector<std::vector<std::uint32_t>> members_;
};

} // namespace scree::rocks
