// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <cstddef>
#include <span>

namespace scree {

/// The share of each pixel's area that a set of rings covers. Every edge adds its signed area as
/// differences along each row; their running sum is the winding number averaged over each pixel
/// (the scheme of R. Levien's font-rs, 2016).
class Coverage {
  public:
    /// Covers the pixels that `box` touches within `clip`, both in pixels.
    Coverage(const Box2& box, const Box2& clip);

    /// Adds one ring. Holes wind opposite to outer rings.
    void add(std::span<const Vec2> ring);

    int left() const { return left_; }
    int top() const { return top_; }
    int width() const { return width_; } // 0 when nothing lies within the clip
    int height() const { return height_; }

    /// Calls paint(x, share) for every covered pixel of a row; row 0 is at `top`.
    template <class Paint>
    void for_row(int row, const Paint& paint) const {
        const double* difference = &differences_[std::size_t(row) * std::size_t(width_ + 2)];
        double winding = 0;
        for (int x = 0; x < width_; ++x) {
            winding += difference[x];
            const double share = std::min(1.0, std::abs(winding));
            if (share > 1e-6)
                paint(left_ + x, share);
        }
    }

  private:
    void add_edge(Vec2 a, Vec2 b);
    void add_span(int row, double x0, double x1, double height_share);

    int left_ = 0, top_ = 0, width_ = 0, height_ = 0;
    std::vector<double> differences_;
};

} // namespace scree
