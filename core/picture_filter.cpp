// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture_filter.h"

#include "core/parallel.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

// Mitchell & Netravali (1988), "Reconstruction filters in computer graphics", B = C = 1/3.
float mitchell(float x) {
    x = std::abs(x);
    if (x >= 2)
        return 0;
    if (x >= 1)
        return ((-7.0F / 18 * x + 2) * x - 10.0F / 3) * x + 16.0F / 9;
    return (7.0F / 6 * x - 2) * x * x + 8.0F / 9;
}

// The chosen mip level has at least this many texels per pixel, so that the reconstruction kernel
// removes the frequencies near the level's Nyquist limit, which the halving filter lets through.
constexpr double texels_per_pixel = 1.5;

struct Taps {
    int first = 0;
    std::vector<float> weights; // sum 1
};

// The filter weights of output pixel `i` when a row of `from` pixels is resampled to `to`.
Taps taps(int i, int from, int to) {
    const double width = double(from) / to;
    const double centre = (i + 0.5) * width;
    Taps out;
    out.first = static_cast<int>(std::ceil(centre - 2 * width - 0.5));
    const int last = static_cast<int>(std::floor(centre + 2 * width - 0.5));
    float sum = 0;
    for (int x = out.first; x <= last; ++x) {
        out.weights.push_back(mitchell(static_cast<float>((x + 0.5 - centre) / width)));
        sum += out.weights.back();
    }
    for (float& weight : out.weights)
        weight /= sum;
    return out;
}

void add(Rgba& sum, const float* pixel, float weight) {
    for (std::size_t c = 0; c < 4; ++c)
        sum[c] += weight * pixel[c];
}

// Clamps the ringing of the cubic filter: alpha to [0, 1], colours to >= 0.
Rgba without_ringing(Rgba v) {
    if (v[3] <= 0)
        return {};
    const float excess = std::max(1.0F, v[3]);
    for (float& c : v)
        c = std::max(0.0F, c / excess);
    return v;
}

/// A 2 x 2 matrix, given by the images of the two axes.
using Map = std::array<Vec2, 2>;

Vec2 mapped(const Map& m, const Vec2& p) { return m[0] * p.x + m[1] * p.y; }

Map inverse(const Map& m) {
    const double d = cross(m[0], m[1]);
    return {Vec2(m[1].y, -m[0].y) / d, Vec2(-m[1].x, m[0].x) / d};
}

struct Axes {
    Vec2 direction; // of the larger one, in pixels, a unit vector
    double large = 0, small = 0;
};

// The axes of the ellipse that the matrix maps the unit circle to (its singular values).
Axes principal(const Map& m) {
    const double xx = m[0].x * m[0].x + m[1].x * m[1].x;
    const double yy = m[0].y * m[0].y + m[1].y * m[1].y;
    const double xy = m[0].x * m[0].y + m[1].x * m[1].y;
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    Axes out;
    out.direction = {std::cos(angle), std::sin(angle)};
    const double mean = (xx + yy) / 2;
    out.large = std::sqrt(mean + std::hypot((xx - yy) / 2, xy));
    out.small = std::abs(cross(m[0], m[1])) / out.large;
    return out;
}

// Along each principal axis the kernel is scaled to a pixel or to a texel, whichever is larger.
Map kernel_from_texel(const Map& pixel_from_texel) {
    const Axes axes = principal(pixel_from_texel);
    if (axes.large <= 1)
        return pixel_from_texel;
    if (axes.small >= 1)
        return {Vec2(1, 0), Vec2(0, 1)};
    const Vec2 side(-axes.direction.y, axes.direction.x);
    Map out;
    for (std::size_t i = 0; i < 2; ++i)
        out[i] = {pixel_from_texel[i].dot(axes.direction) / axes.large,
                  pixel_from_texel[i].dot(side)};
    return out;
}

} // namespace

PictureFilter::PictureFilter(const Image& picture, Beyond beyond) : beyond_(beyond) {
    assert(picture.channels.size() == 4 && picture.width > 0 && picture.height > 0);
    levels_.push_back(picture);
    while (levels_.back().width > 1 || levels_.back().height > 1)
        levels_.push_back(halved(levels_.back()));
}

int PictureFilter::wrapped(int i, int size) const {
    if (beyond_ == Beyond::clamped)
        return std::clamp(i, 0, size - 1);
    const int rest = i % size;
    return rest < 0 ? rest + size : rest;
}

Image PictureFilter::halved(const Image& from) const {
    const int width = (from.width + 1) / 2;
    const int height = (from.height + 1) / 2;
    Image across(width, from.height, from.channels);
    std::vector<Taps> columns;
    for (int x = 0; x < width; ++x)
        columns.push_back(taps(x, from.width, width));
    parallel_for(std::size_t(from.height), 16, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) {
            const Taps& column = columns[std::size_t(x)];
            Rgba sum{};
            for (std::size_t i = 0; i < column.weights.size(); ++i)
                add(sum, from.at(wrapped(column.first + static_cast<int>(i), from.width), y),
                    column.weights[i]);
            std::copy(sum.begin(), sum.end(), across.at(x, y));
        }
    });
    Image out(width, height, from.channels);
    parallel_for(std::size_t(height), 16, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        const Taps rows = taps(y, from.height, height);
        for (int x = 0; x < width; ++x) {
            Rgba sum{};
            for (std::size_t i = 0; i < rows.weights.size(); ++i)
                add(sum, across.at(x, wrapped(rows.first + static_cast<int>(i), from.height)),
                    rows.weights[i]);
            std::copy(sum.begin(), sum.end(), out.at(x, y));
        }
    });
    return out;
}

PictureFilter::Placed PictureFilter::placed(const PicturePlace& place) const {
    const auto texel = [&](const Image& level) {
        return Map{place.u / level.width, place.v / level.height};
    };
    const double finest = principal(texel(levels_.front())).large; // pixels per texel
    const int wanted = static_cast<int>(std::floor(-std::log2(finest * texels_per_pixel)));
    Placed out;
    out.picture_ = this;
    out.level_ = &level(std::clamp(wanted, 0, levels() - 1));
    out.origin_ = place.origin;
    const Map pixel_from_texel = texel(*out.level_);
    out.texel_from_pixel_ = inverse(pixel_from_texel);
    out.kernel_from_texel_ = kernel_from_texel(pixel_from_texel);
    const Map texel_from_kernel = inverse(out.kernel_from_texel_);
    out.reach_ = {2 * (std::abs(texel_from_kernel[0].x) + std::abs(texel_from_kernel[1].x)),
                  2 * (std::abs(texel_from_kernel[0].y) + std::abs(texel_from_kernel[1].y))};
    return out;
}

Rgba PictureFilter::Placed::at(const Vec2& pixel) const {
    const Vec2 centre = mapped(texel_from_pixel_, pixel - origin_) - Vec2(0.5, 0.5);
    const Vec2 low = centre - reach_, high = centre + reach_;
    const int first = static_cast<int>(std::ceil(low.x));
    const int last = static_cast<int>(std::floor(high.x));
    Rgba sum{};
    float total = 0;
    for (int y = static_cast<int>(std::ceil(low.y)); y <= high.y; ++y) {
        const int row = picture_->wrapped(y, level_->height);
        for (int x = first; x <= last; ++x) {
            const Vec2 k = mapped(kernel_from_texel_, Vec2(x, y) - centre);
            const float weight =
                mitchell(static_cast<float>(k.x)) * mitchell(static_cast<float>(k.y));
            if (weight == 0)
                continue;
            add(sum, level_->at(picture_->wrapped(x, level_->width), row), weight);
            total += weight;
        }
    }
    for (float& v : sum)
        v /= total;
    return without_ringing(sum);
}

Rgba PictureFilter::bilinear(const Image& level, const Vec2& uv) const {
    const double x = uv.x * level.width - 0.5;
    const double y = (1 - uv.y) * level.height - 0.5;
    const double left = std::floor(x), top = std::floor(y);
    Rgba sum{};
    for (const int j : {0, 1})
        for (const int i : {0, 1}) {
            const double weight =
                (i == 1 ? x - left : left + 1 - x) * (j == 1 ? y - top : top + 1 - y);
            add(sum,
                level.at(wrapped(static_cast<int>(left) + i, level.width),
                         wrapped(static_cast<int>(top) + j, level.height)),
                static_cast<float>(weight));
        }
    return sum;
}

Rgba PictureFilter::trilinear(const Vec2& uv, double width) const {
    // Brought into the picture first, since texel indices far outside would overflow an int.
    const Vec2 near = beyond_ == Beyond::repeated
                          ? Vec2(uv.x - std::floor(uv.x), uv.y - std::floor(uv.y))
                          : Vec2(std::clamp(uv.x, 0.0, 1.0), std::clamp(uv.y, 0.0, 1.0));
    const double last = levels() - 1;
    const double texels = width * std::sqrt(double(levels_.front().width) * levels_.front().height);
    const double depth = std::clamp(std::log2(std::max(1e-9, texels)), 0.0, last);
    const int below = static_cast<int>(depth);
    const Rgba fine = bilinear(level(below), near);
    const auto share = static_cast<float>(depth - below);
    if (share == 0)
        return without_ringing(fine);
    const Rgba coarse = bilinear(level(below + 1), near);
    Rgba sum{};
    add(sum, fine.data(), 1 - share);
    add(sum, coarse.data(), share);
    return without_ringing(sum);
}

} // namespace scree
