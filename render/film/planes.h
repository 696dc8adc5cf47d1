// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as separate planes of floats, for loops over vectors of pixels.
#pragma once

#include "core/parallel.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace scree {

/// Planes of one size. Around each is a border that repeats the picture's edge, and its size is
/// rounded up to whole tiles, so that windows around the pixels of a tile never leave memory.
class Planes {
  public:
    static constexpr int border = 24; // what the windows of denoise_vector.cpp reach for at most
    static constexpr int tile_width = 32;
    static constexpr int tile_height = 16;

    Planes(int width, int height, int count)
        : width_(width), height_(height), stride_(rounded(width, tile_width) + borders),
          rows_(rounded(height, tile_height) + borders),
          values_(std::size_t(count) * stride_ * rows_) {}

    int width() const { return width_; }
    int height() const { return height_; }
    std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(stride_); }

    /// x, y: may lie in the border.
    float* at(int plane, int x, int y) { return &values_[index(plane, x, y)]; }
    const float* at(int plane, int x, int y) const { return &values_[index(plane, x, y)]; }

    /// Repeats the edge of the picture in the border of a plane.
    void extend(int plane) {
        for (int y = 0; y < height_; ++y) {
            float* row = at(plane, 0, y);
            std::fill(row - border, row, row[0]);
            std::fill(row + width_, row - border + stride_, row[width_ - 1]);
        }
        const auto copy_row = [&](int from, int to) {
            std::copy_n(at(plane, -border, from), stride_, at(plane, -border, to));
        };
        for (int y = -border; y < 0; ++y)
            copy_row(0, y);
        for (int y = height_; y < int(rows_) - border; ++y)
            copy_row(height_ - 1, y);
    }

    /// Calls body(x, y) for the first pixel of every tile, in parallel.
    template <class Body>
    void for_tiles(const Body& body) const {
        const std::size_t across = rounded(width_, tile_width) / tile_width;
        const std::size_t down = rounded(height_, tile_height) / tile_height;
        parallel_for(across * down, 1, [&](std::size_t i) {
            body(int(i % across) * tile_width, int(i / across) * tile_height);
        });
    }

    /// Calls body(y) for every row, in parallel.
    template <class Body>
    void for_rows(const Body& body) const {
        parallel_for(std::size_t(height_), 8, [&](std::size_t y) { body(int(y)); });
    }

  private:
    static constexpr auto borders = 2 * std::size_t{border};

    static std::size_t rounded(int size, int step) {
        return std::size_t((size + step - 1) / step) * std::size_t(step);
    }
    std::size_t index(int plane, int x, int y) const {
        return (std::size_t(plane) * rows_ + std::size_t(y + border)) * stride_ +
               std::size_t(x + border);
    }

    int width_;
    int height_;
    std::size_t stride_;
    std::size_t rows_;
    std::vector<float> values_;
};

} // namespace scree
