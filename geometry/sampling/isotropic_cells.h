// SPDX-License-Identifier: GPL-3.0-or-later
// The grid in which disks of one distance are sampled: the time of each cell's next event and its
// sample, with fast look-up of the 25 cells around one.
#pragma once

#include "core/float4.h"
#include "geometry/sampling/domain_cells.h"
#include "geometry/sampling/local_clock.h"

#include <bit>
#include <cstring>

namespace scree {

/// The samples in the 25 cells around one, relative to its corner [m].
struct NearSamples {
    std::array<Vec2, 24> position; // the first `count` are set
    std::size_t count = 0;

    NearSamples() {} // not defaulted: it would fill the positions
};

/// Cells so small that each holds one sample at most. Around the grid lie `margin` rows and
/// columns: on a torus images of the cells across, else cells in which nothing happens.
class IsotropicCells {
  public:
    static constexpr int margin = 2; // cells: a distance is less than the sides of three

    IsotropicCells(const CellGrid& grid, bool torus);

    const CellGrid& grid() const { return grid_; }
    bool is_torus() const { return torus_; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(time_.size()); }
    std::uint32_t stride() const { return stride_; } // from a cell to that in the next row
    std::uint32_t index(int column, int row) const {
        return std::uint32_t(row + margin) * stride_ + std::uint32_t(column + margin);
    }

    /// The cell of which this one is an image, or itself.
    std::uint32_t real_of(std::uint32_t c) const {
        const auto wrapped = [](int i, int n) { return i < 0 ? i + n : i >= n ? i - n : i; };
        return index(wrapped(column_of(c), grid_.columns), wrapped(row_of(c), grid_.rows));
    }

    float time(std::uint32_t c) const { return time_[c]; }
    void set_time(std::uint32_t c, float time) {
        for_images(c, [&](std::uint32_t i) { time_[i] = time; });
    }

    /// Of the 25 cells around, the one whose time is the least; c itself unless another's is less.
    std::uint32_t earliest_near(std::uint32_t c) const;

    /// `position`: from the cell's corner [m].
    void set_sample(std::uint32_t c, const Vec2& position) {
        for_images(c, [&](std::uint32_t i) {
            sample_[i] = position;
            has_sample_[i >> 3] |= static_cast<std::uint8_t>(1U << (i & 7U));
        });
    }
    bool has_sample(std::uint32_t c) const { return (has_sample_[c >> 3] >> (c & 7U) & 1U) != 0; }
    const Vec2& sample(std::uint32_t c) const { return sample_[c]; }
    NearSamples samples_near(std::uint32_t c) const;

  private:
    int column_of(std::uint32_t c) const { return int(c % stride_) - margin; }
    int row_of(std::uint32_t c) const { return int(c / stride_) - margin; }
    template <class Set>
    void for_images(std::uint32_t c, const Set& set);
    std::uint32_t occupied_near(std::uint32_t c) const;

    CellGrid grid_;
    bool torus_;
    std::uint32_t stride_;
    std::array<std::uint32_t, 25> offset_{}; // of the indices of the cells around, row by row
    std::array<Vec2, 25> shift_;             // of their corners from that of the middle one [m]
    std::vector<float> time_;
    std::vector<Vec2> sample_;             // from the cell's corner [m]
    std::vector<std::uint8_t> has_sample_; // a bit for each cell
    std::vector<bool> has_images_;         // of a torus
};

// Calls set for the cell and on a torus for its images in the rows and columns around the grid.
template <class Set>
inline void IsotropicCells::for_images(std::uint32_t c, const Set& set) {
    set(c);
    if (!torus_ || !has_images_[c])
        return;
    const auto other = [](int i, int n) {
        return i < margin ? i + n : i >= n - margin ? i - n : i;
    };
    const int column = column_of(c);
    const int row = row_of(c);
    const int across = other(column, grid_.columns);
    const int along = other(row, grid_.rows);
    if (across != column)
        set(index(across, row));
    if (along != row)
        set(index(column, along));
    if (across != column && along != row)
        set(index(across, along));
}

inline std::uint32_t IsotropicCells::earliest_near(std::uint32_t c) const {
    static_assert(margin == 2);
    const float* const first = &time_[c] - margin * std::ptrdiff_t(stride_) - margin;
    const auto four = [&](std::size_t i) {
        Float4 v;
        std::memcpy(&v, first + i * stride_, sizeof v);
        return v;
    };
    const auto fifth = [&](std::size_t i) { return first[i * stride_ + 4]; };
    const Float4 least =
        minimum(minimum(minimum(four(0), four(1)), minimum(four(2), four(3))), four(4));
    const float all =
        std::min({std::min(least[0], least[1]), std::min(least[2], least[3]),
                  std::min(fifth(0), fifth(1)), std::min(fifth(2), fifth(3)), fifth(4)});
    if (!(all < time_[c]))
        return c;
    for (std::size_t i = 0;; ++i) {
        const bool in_four = any(four(i) == Float4{} + all);
        if (!in_four && fifth(i) != all)
            continue;
        std::size_t j = 4;
        while (in_four && first[i * stride_ + --j] != all) {
        }
        const auto found = static_cast<std::uint32_t>(first + i * stride_ + j - time_.data());
        return torus_ ? real_of(found) : found;
    }
}

// A bit for each of the 25 cells around, row by row.
inline std::uint32_t IsotropicCells::occupied_near(std::uint32_t c) const {
    std::uint32_t mask = 0;
    std::uint32_t from = c - margin * stride_ - margin;
    for (unsigned row = 0; row < 5; ++row, from += stride_) {
        std::uint16_t bits = 0;
        std::memcpy(&bits, &has_sample_[from >> 3], sizeof bits);
        mask |= (std::uint32_t(bits) >> (from & 7U) & 31U) << (5 * row);
    }
    return mask;
}

inline NearSamples IsotropicCells::samples_near(std::uint32_t c) const {
    NearSamples near;
    for (std::uint32_t mask = occupied_near(c); mask != 0; mask &= mask - 1) {
        const auto k = static_cast<std::uint32_t>(std::countr_zero(mask));
        near.position[near.count++] = sample_[c + offset_[k]] + shift_[k];
    }
    return near;
}

} // namespace scree
