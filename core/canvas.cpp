// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/canvas.h"

#include "core/coverage.h"
#include "core/display_encoding.h"
#include "core/parallel.h"

#include <algorithm>
#include <cmath>

namespace scree {

Canvas::Canvas(int width, int height, const Color& paper) : image_(width, height, {"R", "G", "B"}) {
    for (std::size_t i = 0; i < image_.pixels.size(); ++i)
        image_.pixels[i] = paper[static_cast<int>(i % 3)];
    clip_nothing();
}

Canvas::Canvas(int width, int height) : image_(width, height, {"R", "G", "B", "A"}) {
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
    if (image_.channels.size() == 4)
        pixel[3] += static_cast<float>(share) * (1 - pixel[3]);
}

void Canvas::paint(const Coverage& coverage, const Color& color, double opacity) {
    for (int row = 0; row < coverage.height(); ++row)
        coverage.for_row(row, [&](int x, double share) {
            blend(x, coverage.top() + row, share * opacity, color);
        });
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

void Canvas::draw(const PictureFilter& picture, const PicturePlace& place) {
    const Vec2 far = place.origin + place.u + place.v;
    const Vec2 corners[] = {place.origin, place.origin + place.u, far, place.origin + place.v};
    Box2 box;
    for (const Vec2& corner : corners)
        box.extendBy(corner);
    Coverage coverage(box, clip_);
    if (coverage.height() == 0)
        return;
    coverage.add(corners);
    const PictureFilter::Placed placed = picture.placed(place);
    const bool has_alpha = image_.channels.size() == 4;
    parallel_for(std::size_t(coverage.height()), 8, [&](std::size_t i) {
        const int row = static_cast<int>(i);
        const int y = coverage.top() + row;
        coverage.for_row(row, [&](int x, double share) {
            const Rgba over = placed.at({x + 0.5, y + 0.5});
            const auto part = static_cast<float>(share);
            float* pixel = image_.at(x, y);
            for (std::size_t c = 0; c < (has_alpha ? 4 : 3); ++c)
                pixel[c] = part * over[c] + pixel[c] * (1 - part * over[3]);
        });
    });
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
    const auto encode = [](float v) { return display_from_linear(std::clamp(v, 0.0F, 1.0F)); };
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
