// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/winding_number.h"

#include <algorithm>

namespace scree {

namespace {

constexpr std::size_t most_slabs = 256; // bounds the memory where many edges are long

} // namespace

WindingNumber::WindingNumber(const Ring& ring) : ring_(ring) {
    Box2 box;
    for (const Vec2& p : ring)
        box.extendBy(p);
    axis_ = box.size().x >= box.size().y ? 0 : 1;
    const double length = box.size()[axis_];
    slabs_.resize(length > 0 ? std::clamp<std::size_t>(ring.size() / 4, 1, most_slabs) : 1);
    low_ = box.min[axis_];
    slabs_per_length_ = length > 0 ? double(slabs_.size()) / length : 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2& next = ring[(i + 1) % ring.size()];
        const auto [first, last] = std::minmax({slab_of(ring[i][axis_]), slab_of(next[axis_])});
        for (std::size_t s = first; s <= last; ++s)
            slabs_[s].push_back(static_cast<std::uint32_t>(i));
    }
}

std::size_t WindingNumber::slab_of(double along) const {
    const double slab = (along - low_) * slabs_per_length_;
    return std::min(static_cast<std::size_t>(std::max(slab, 0.0)), slabs_.size() - 1);
}

// Counts the edges that cross the line across the slabs' axis on one side of the point, by their
// direction. With the axes exchanged the polygon is mirrored, which reverses its turn.
int WindingNumber::operator()(const Vec2& point) const {
    const double along = point[axis_];
    const int turn = axis_ == 1 ? 1 : -1;
    int turns = 0;
    for (const std::uint32_t i : slabs_[slab_of(along)]) {
        const Vec2& a = ring_[i];
        const Vec2& b = ring_[(i + 1) % ring_.size()];
        const double side = turn * cross(b - a, point - a);
        if (a[axis_] <= along && along < b[axis_] && side > 0)
            turns += turn;
        else if (b[axis_] <= along && along < a[axis_] && side < 0)
            turns -= turn;
    }
    return turns;
}

} // namespace scree
