// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/canvas.h"

#include <algorithm>
#include <cmath>

namespace scree {

/// Signed area that edges cover of the pixels of a box, as differences along each row: the running
/// sum of a row is the winding number averaged over each pixel (the scheme of R. Levien's font-rs,
/// 2016).
struct Canvas::Coverage {
    int left = 0, top = 0, width = 0, height = 0;
    std::vector<double> differences;

    Coverage(const Box2& box, const Box2& clip) {
        left = static_cast<int>(std::floor(std::max(box.min.x, clip.min.x)));
        top = static_cast<int>(std::floor(std::max(box.min.y, clip.min.y)));
        width = static_cast<int>(std::ceil(std::min(box.max.x, clip.max.x))) - left;
        height = static_cast<int>(std::ceil(std::min(box.max.y, clip.max.y))) - top;
        if (width <= 0 || height <= 0)
            width = height = 0;
        differences.assign(std::size_t(width + 2) * std::size_t(height), 0.0);
    }

    void add(std::span<const Vec2> ring) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            add_edge(ring[j], ring[i]);
    }

    void add_edge(Vec2 a, Vec2 b) {
        const double sign = a.y < b.y ? 1 : -1;
        if (a.y > b.y)
            std::swap(a, b);
        const double first = std::max(a.y, double(top));
        const double last = std::min(b.y, double(top + height));
        if (!(first < last))
            return;
        const double slope = (b.x - a.x) / (b.y - a.y);
        for (int y = static_cast<int>(first); y < last; ++y) {
            const double y0 = std::max(first, double(y));
            const double y1 = std::min(last, double(y + 1));
            if (y0 < y1)
                add_span(y - top, a.x + (y0 - a.y) * slope, a.x + (y1 - a.y) * slope,
                         sign * (y1 - y0));
        }
    }

    // An edge inside one row: each pixel it crosses gets its share of the height, split by where
    // in the pixel it crosses.
    void add_span(int row, double x0, double x1, double height_share) {
        x0 = std::clamp(x0 - left, 0.0, double(width));
        x1 = std::clamp(x1 - left, 0.0, double(width));
        if (x0 > x1)
            std::swap(x0, x1);
        double* out = &differences[std::size_t(row) * std::size_t(width + 2)];
        const int first = static_cast<int>(x0);
        const int last = static_cast<int>(x1);
        for (int x = first; x <= last; ++x) {
            const double l = std::max(x0, double(x));
            const double r = std::min(x1, double(x + 1));
            const double share =
                x1 > x0 ? height_share * std::max(0.0, r - l) / (x1 - x0) : height_share;
            const double covered = 1 - ((l + r) / 2 - x);
            out[x] += share * covered;
            out[x + 1] += share * (1 - covered);
        }
    }
};

Canvas::Canvas(int width, int height, const Color& paper) : image_(width, height, {"R", "G", "B"}) {
    for (std::size_t i = 0; i < image_.pixels.size(); ++i)
        image_.pixels[i] = paper[static_cast<int>(i % 3)];
    clip_nothing();
}

void Canvas::clip(const Box2& box) {
    clip_nothing();
    clip_.min = {std::max(0.0, std::round(box.min.x)), std::max(0.0, std::round(box.min.y))};
    clip_.max = {std::min(clip_.max.x, std::round(box.max.x)),
                 std::min(clip_.max.y, std::round(box.max.y))};
}

void Canvas::clip_nothing() {
    clip_ = Box2(Vec2(0, 0), Vec2(double(image_.width), double(image_.height)));
}

void Canvas::blend(int x, int y, double share, const Color& color) {
    float* pixel = image_.at(x, y);
    for (int c = 0; c < 3; ++c)
        pixel[c] += static_cast<float>(share) * (color[c] - pixel[c]);
}

void Canvas::paint(const Coverage& coverage, const Color& color, double opacity) {
    for (int row = 0; row < coverage.height; ++row) {
        double winding = 0;
        for (int x = 0; x < coverage.width; ++x) {
            winding += coverage.differences[std::size_t(row) * std::size_t(coverage.width + 2) +
                                            std::size_t(x)];
            const double share = std::min(1.0, std::abs(winding)) * opacity;
            if (share > 1e-6)
                blend(coverage.left + x, coverage.top + row, share, color);
        }
    }
}

void Canvas::fill(std::span<const Ring> rings, const Color& color, double opacity) {
    Box2 box;
    for (const Ring& ring : rings)
        for (const Vec2& point : ring)
            box.extendBy(point);
    if (box.isEmpty())
        return;
    Coverage coverage(box, clip_);
    for (const Ring& ring : rings)
        coverage.add(ring);
    paint(coverage, color, opacity);
}

void Canvas::stroke(std::span<const Vec2> points, double width, const Color& color, bool closed,
                    double opacity) {
    Box2 box;
    for (const Vec2& point : points)
        box.extendBy(point);
    if (box.isEmpty())
        return;
    const Vec2 half(width / 2, width / 2);
    Coverage coverage({box.min - half, box.max + half}, clip_);
    const int segments = std::clamp(static_cast<int>(4 * width), 8, 64);
    for (std::size_t i = 0; i < points.size(); ++i) {
        coverage.add(circle_ring(points[i], width / 2, segments));
        if (i + 1 == points.size() && !closed)
            break;
        const Vec2& a = points[i];
        const Vec2& b = points[(i + 1) % points.size()];
        const double length = (b - a).length();
        if (length == 0)
            continue;
        const Vec2 side = Vec2(-(b - a).y, (b - a).x) * (width / 2 / length);
        coverage.add(Ring{a - side, b - side, b + side, a + side});
    }
    paint(coverage, color, opacity);
}

void Canvas::line(const Vec2& a, const Vec2& b, double width, const Color& color) {
    const Vec2 points[] = {a, b};
    stroke(points, width, color);
}

void Canvas::text(const Vec2& at, const std::string& text, double size, const Color& color,
                  Align align, bool upwards) {
    const TextMask mask = text_mask(text, size);
    const int shift = align == Align::left     ? 0
                      : align == Align::centre ? mask.left + mask.image.width / 2
                                               : mask.left + mask.image.width;
    const int x0 = static_cast<int>(std::round(at.x));
    const int y0 = static_cast<int>(std::round(at.y));
    for (int row = 0; row < mask.image.height; ++row)
        for (int column = 0; column < mask.image.width; ++column) {
            const int along = mask.left + column - shift;
            const int down = mask.top + row;
            const int x = upwards ? x0 + down : x0 + along;
            const int y = upwards ? y0 - along : y0 + down;
            if (x >= 0 && y >= 0 && x < image_.width && y < image_.height)
                blend(x, y, *mask.image.at(column, row), color);
        }
}

Color display_color(const Color& linear) {
    const auto encode = [](float v) {
        v = std::clamp(v, 0.0F, 1.0F);
        return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
    };
    return {encode(linear.x), encode(linear.y), encode(linear.z)};
}

Color palette_color(std::size_t index) {
    static constexpr std::uint32_t colors[] = {0x4477aa, 0xee8866, 0x228833, 0xccbb44, 0xaa3377,
                                               0x66ccee, 0x99582a, 0xbbbbbb, 0x44bb99, 0xffaabb};
    const std::uint32_t rgb = colors[index % std::size(colors)]; // after P. Tol (2021)
    const auto channel = [&](int shift) { return float((rgb >> shift) & 0xff) / 255.0F; };
    return {channel(16), channel(8), channel(0)};
}

Ring circle_ring(const Vec2& centre, double radius, int segments) {
    Ring ring;
    for (int i = 0; i < segments; ++i)
        ring.push_back(centre + rotate({radius, 0}, 2 * pi * i / segments));
    return ring;
}

} // namespace scree
