// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/footprint.h"
#include "generators/rocks/ground.h"
#include "generators/rocks/rock_surface.h"

#include <algorithm>
#include <limits>

namespace scree::rocks {

/// The tops of the rocks placed so far, and the ground, on a grid of square cells. A cell holds the
/// highest of what is in it, and which rock that is.
class HeightMap {
  public:
    static constexpr std::uint32_t no_rock = 0xFFFFFFFF;

    /// @param area that is covered at least [m]
    HeightMap(const Box2& area, double cell, const Ground& ground);

    double cell() const { return cell_; }
    /// The middle of a cell.
    Vec2 place(int i, int j) const { return origin_ + Vec2(i, j) * cell_; }
    int column(double x) const {
        return static_cast<int>(std::floor((x - origin_.x) / cell_ + 0.5));
    }
    int row(double z) const { return static_cast<int>(std::floor((z - origin_.y) / cell_ + 0.5)); }

    /// The height at which a rock whose centre is over cell (i, j) is held by what is below it; the
    /// ground is taken to be lower by `sink`. No more than known to be above `enough` [m].
    double rest(const Footprint& under, int i, int j, double sink,
                double enough = std::numeric_limits<double>::max()) const;

    /// Calls visit(index in the footprint, height of what is there) for the cells that a footprint
    /// over cell (i, j) covers.
    template <class Visit>
    void each_under(const Footprint& under, int i, int j, double sink, const Visit& visit) const;

    /// Which rock is the highest in a cell; no_rock for the ground and beyond the map.
    std::uint32_t rock(int i, int j) const {
        return contains(i, j) ? rocks_[index(i, j)] : no_rock;
    }

    /// The height of a cell, of its rock or else of the ground [m].
    double height(int i, int j) const {
        return contains(i, j) ? double(std::max(tops_[index(i, j)], ground(i, j))) : 0;
    }

    /// Adds the top of rock `number`.
    void add(const PlacedRock& rock, const RockSurface& surface, std::uint32_t number) {
        add(rock, surface, number, 0, depth_);
    }

    /// Adds the tops of all rocks that have been placed.
    void add(std::span<const PlacedRock> rocks, std::span<const RockSurface> surfaces);

  private:
    /// Only in rows from `first_row` to before `end_row`.
    void add(const PlacedRock& rock, const RockSurface& surface, std::uint32_t number,
             int first_row, int end_row);
    bool contains(int i, int j) const { return i >= 0 && j >= 0 && i < width_ && j < depth_; }
    std::size_t index(int i, int j) const {
        return std::size_t(j) * std::size_t(width_) + std::size_t(i);
    }
    float ground(int i, int j) const {
        return ground_.empty() ? plane_ - fall_ * static_cast<float>(j) : ground_[index(i, j)];
    }

    double cell_;
    Vec2 origin_; // middle of cell (0, 0)
    int width_;
    int depth_;
    float plane_ = 0;           // a plane's greatest height in the cells of row 0
    float fall_ = 0;            // of a plane, from one row to the next
    std::vector<float> ground_; // of a mesh
    std::vector<float> tops_;
    std::vector<std::uint32_t> rocks_;
};

template <class Visit>
void HeightMap::each_under(const Footprint& under, int i, int j, double sink,
                           const Visit& visit) const {
    const auto lower = static_cast<float>(sink);
    for (int row = 0; row < under.depth; ++row)
        for (int column = 0; column < under.width; ++column) {
            const int x = i + under.first_x + column;
            const int z = j + under.first_z + row;
            const std::size_t k = std::size_t(row) * std::size_t(under.width) + std::size_t(column);
            if (contains(x, z) && under.has(under.heights[k]))
                visit(k, std::max(tops_[index(x, z)], ground(x, z) - lower));
        }
}

} // namespace scree::rocks
