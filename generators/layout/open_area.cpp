// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/open_area.h"

#include <algorithm>

namespace scree {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

struct Split {
    Fragment inside, outside;
    bool full = false; // more corners than a fragment can have
};

void append(Split& split, Fragment& to, float x, float y) {
    if (to.count == Fragment::capacity)
        split.full = true;
    else
        to.add(x, y);
}

/// Cuts along normal . x = offset.
Split split(const Fragment& f, float nx, float ny, float offset) {
    Split result;
    float px = f.x[index(f.count - 1)], py = f.y[index(f.count - 1)];
    float before = nx * px + ny * py - offset;
    for (int i = 0; i < f.count; ++i) {
        const float x = f.x[index(i)], y = f.y[index(i)];
        const float now = nx * x + ny * y - offset;
        if ((before < 0) != (now < 0) && before != 0 && now != 0) {
            const float t = before / (before - now);
            const float cx = px + (x - px) * t, cy = py + (y - py) * t;
            append(result, result.inside, cx, cy);
            append(result, result.outside, cx, cy);
        }
        if (now <= 0)
            append(result, result.inside, x, y);
        if (now >= 0)
            append(result, result.outside, x, y);
        px = x;
        py = y;
        before = now;
    }
    return result;
}

// A convex polygon's area is at least half its longest extent times its width across.
bool is_sliver(const Fragment& f, float sliver) {
    return f.area() < sliver * std::max(f.half.x, f.half.y);
}

} // namespace

float Fragment::area() const {
    float sum = 0;
    for (int i = 2; i < count; ++i)
        sum += (x[index(i - 1)] - x[0]) * (y[index(i)] - y[0]) -
               (y[index(i - 1)] - y[0]) * (x[index(i)] - x[0]);
    return sum / 2;
}

Vec2f Fragment::centroid() const {
    float sum = 0, cx = 0, cy = 0;
    for (int i = 2; i < count; ++i) {
        const float ax = x[index(i - 1)] - x[0], ay = y[index(i - 1)] - y[0];
        const float bx = x[index(i)] - x[0], by = y[index(i)] - y[0];
        const float twice = ax * by - ay * bx;
        sum += twice;
        cx += twice * (ax + bx);
        cy += twice * (ay + by);
    }
    if (!(sum > 0))
        return {x[0], y[0]};
    return {x[0] + cx / (3 * sum), y[0] + cy / (3 * sum)};
}

Vec2f Fragment::at(float u, float v) const {
    float left = u * 2 * area();
    for (int i = 2; i < count; ++i) {
        const float ax = x[index(i - 1)] - x[0], ay = y[index(i - 1)] - y[0];
        const float bx = x[index(i)] - x[0], by = y[index(i)] - y[0];
        const float twice = ax * by - ay * bx;
        if (left < twice || i + 1 == count) {
            // What is left of u is uniform again; a square folded onto a triangle.
            float s = std::clamp(twice > 0 ? left / twice : 0.0F, 0.0F, 1.0F), t = v;
            if (s + t > 1) {
                s = 1 - s;
                t = 1 - t;
            }
            return {x[0] + ax * s + bx * t, y[0] + ay * s + by * t};
        }
        left -= twice;
    }
    return {x[0], y[0]};
}

void Fragment::close() {
    Imath::Box2f box;
    for (int i = 0; i < count; ++i)
        box.extendBy(Vec2f(x[index(i)], y[index(i)]));
    centre = box.center();
    half = box.size() * 0.5F;
}

Fragment box_fragment(const Imath::Box2f& box) {
    Fragment result;
    result.add(box.min.x, box.min.y);
    result.add(box.max.x, box.min.y);
    result.add(box.max.x, box.max.y);
    result.add(box.min.x, box.max.y);
    result.close();
    return result;
}

Fragment part_of(const Fragment& fragment, float normal_x, float normal_y, float offset) {
    Split parts = split(fragment, normal_x, normal_y, offset);
    parts.inside.close();
    if (parts.full)
        return part_of(box_fragment(fragment.box()), normal_x, normal_y, offset);
    return parts.inside;
}

bool subtract(const Fragment& fragment, const HalfPlanes& polygon, float sliver,
              std::vector<Fragment>& rest) {
    for (std::size_t q = 0; q < polygon.offset.size(); ++q) {
        const Float4 nx = polygon.normal_x[q], ny = polygon.normal_y[q];
        const Float4 low = nx * fragment.centre.x + ny * fragment.centre.y -
                           absolute(nx) * fragment.half.x - absolute(ny) * fragment.half.y;
        if (any(low >= polygon.offset[q]))
            return false;
    }
    struct Cut {
        float depth, x, y, offset;
    };
    constexpr int most = 16;
    std::array<Cut, most> cuts;
    int count = 0;
    for (std::size_t q = 0; q < polygon.offset.size(); ++q) {
        const Float4 nx = polygon.normal_x[q], ny = polygon.normal_y[q];
        Float4 low = nx * fragment.x[0] + ny * fragment.y[0], high = low;
        for (int i = 1; i < fragment.count; ++i) {
            const Float4 along = nx * fragment.x[index(i)] + ny * fragment.y[index(i)];
            low = minimum(low, along);
            high = maximum(high, along);
        }
        for (int lane = 0; lane < 4; ++lane) {
            const float offset = polygon.offset[q][lane];
            if (low[lane] >= offset || (high[lane] > offset && count == most))
                return false; // apart, or too many cuts to be worth it
            if (high[lane] > offset)
                cuts[index(count++)] = {high[lane] - offset, nx[lane], ny[lane], offset};
        }
    }
    // The widest cuts first: they leave few large fragments.
    std::sort(cuts.begin(), cuts.begin() + count,
              [](const Cut& a, const Cut& b) { return a.depth > b.depth; });
    const std::size_t before = rest.size();
    Fragment inside = fragment;
    for (int k = 0; k < count; ++k) {
        const Cut& c = cuts[index(k)];
        Split parts = split(inside, c.x, c.y, c.offset);
        if (parts.full || parts.inside.count < 3) {
            rest.resize(before);
            return false;
        }
        if (parts.outside.count >= 3) {
            parts.outside.close();
            if (!is_sliver(parts.outside, sliver))
                rest.push_back(parts.outside);
        }
        inside = parts.inside;
    }
    return true;
}

} // namespace scree
