// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <cstdint>

namespace scree {

/// How often a closed polygon, which may cross itself, goes counter-clockwise around a point.
/// Queries look at the edges of one slab across the polygon's longer side only.
class WindingNumber {
  public:
    /// `ring` must outlive this.
    explicit WindingNumber(const Ring& ring);

    /// 0 outside; any value for points on an edge.
    int operator()(const Vec2& point) const;

  private:
    std::size_t slab_of(double along) const;

    const Ring& ring_;
    int axis_ = 0; // along which the slabs follow each other
    double low_ = 0;
    double slabs_per_length_ = 0;
    std::vector<std::vector<std::uint32_t>> slabs_; // the edges, by their first corner
};

} // namespace scree
