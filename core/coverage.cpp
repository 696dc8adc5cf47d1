// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage.h"

#include <algorithm>

namespace scree {

Coverage::Coverage(const Box2& box, const Box2& clip) {
    left_ = static_cast<int>(std::floor(std::max(box.min.x, clip.min.x)));
    top_ = static_cast<int>(std::floor(std::max(box.min.y, clip.min.y)));
    width_ = static_cast<int>(std::ceil(std::min(box.max.x, clip.max.x))) - left_;
    height_ = static_cast<int>(std::ceil(std::min(box.max.y, clip.max.y))) - top_;
    if (width_ <= 0 || height_ <= 0)
        width_ = height_ = 0;
    differences_.assign(std::size_t(width_ + 2) * std::size_t(height_), 0.0);
}

void Coverage::add(std::span<const Vec2> ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        add_edge(ring[j], ring[i]);
}

void Coverage::add_edge(Vec2 a, Vec2 b) {
    const double sign = a.y < b.y ? 1 : -1;
    if (a.y > b.y)
        std::swap(a, b);
    const double first = std::max(a.y, double(top_));
    const double last = std::min(b.y, double(top_ + height_));
    if (!(first < last))
        return;
    const double slope = (b.x - a.x) / (b.y - a.y);
    for (int y = static_cast<int>(first); y < last; ++y) {
        const double y0 = std::max(first, double(y));
        const double y1 = std::min(last, double(y + 1));
        if (y0 < y1)
            add_span(y - top_, a.x + (y0 - a.y) * slope, a.x + (y1 - a.y) * slope,
                     sign * (y1 - y0));
    }
}

// Adds the part of an edge that lies within one row. Each pixel that it crosses gets its share of
// the height, split by the mean x of the crossing. A part to the left of the box covers the whole
// row, a part to the right covers nothing.
void Coverage::add_span(int row, double x0, double x1, double height_share) {
    x0 -= left_;
    x1 -= left_;
    if (x0 > x1)
        std::swap(x0, x1);
    const double length = x1 - x0;
    double* out = &differences_[std::size_t(row) * std::size_t(width_ + 2)];
    if (x0 < 0)
        out[0] += length > 0 ? height_share * (std::min(x1, 0.0) - x0) / length : height_share;
    if (x1 < 0 || x0 >= width_)
        return;
    const int first = static_cast<int>(std::max(x0, 0.0));
    const int last = static_cast<int>(std::min(x1, double(width_)));
    for (int x = first; x <= last; ++x) {
        const double l = std::max(x0, double(x));
        const double r = std::min(x1, double(x + 1));
        const double share =
            length > 0 ? height_share * std::max(0.0, r - l) / length : height_share;
        const double covered = 1 - ((l + r) / 2 - x);
        out[x] += share * covered;
        out[x + 1] += share * (1 - covered);
    }
}

} // namespace scree
