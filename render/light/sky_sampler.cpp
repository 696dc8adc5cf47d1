// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/light/sky_sampler.h"

#include <algorithm>

namespace scree {

namespace {

// Rows of the table for a gradient, which changes only with height: 2.8 degrees each.
constexpr int gradient_rows = 64;

} // namespace

SkySampler::SkySampler(const Sky& sky, bool compensate)
    : sky_(sky), cos_rotation_(std::cos(sky.rotation)), sin_rotation_(std::sin(sky.rotation)) {
    constant_ = sky.image == nullptr && sky.zenith == sky.horizon && sky.ground == sky.horizon;
    const int width = sky.image ? sky.image->width : 1;
    const int height = sky.image ? sky.image->height : constant_ ? 1 : gradient_rows;
    // Mean radiance of every cell, then its solid angle.
    std::vector<double> mean(std::size_t(width) * std::size_t(height));
    std::vector<double> solid_angle(static_cast<std::size_t>(height));
    double sum = 0;
    for (int y = 0; y < height; ++y) {
        const double top = pi * y / height;
        const double bottom = pi * (y + 1) / height;
        solid_angle[std::size_t(y)] = 2 * pi / width * (std::cos(top) - std::cos(bottom));
        scale_.push_back(static_cast<float>(1 / (solid_angle[std::size_t(y)] * width * height)));
        cosines_.push_back(static_cast<float>(std::cos(top)));
        for (int x = 0; x < width; ++x) {
            double value = 0;
            if (sky.image) { // exact mean of the bilinear interpolation over a texel
                constexpr double part[] = {0.125, 0.75, 0.125};
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        value +=
                            part[dx + 1] * part[dy + 1] * double(luminance(texel(x + dx, y + dy)));
            } else {
                const double middle = (top + bottom) / 2;
                value =
                    double(luminance(radiance(Vec3(static_cast<float>(std::sin(middle)),
                                                   static_cast<float>(std::cos(middle)), 0.0F))));
            }
            mean[std::size_t(y) * std::size_t(width) + std::size_t(x)] = value;
            sum += value * solid_angle[std::size_t(y)];
        }
    }
    cosines_.push_back(-1.0F);
    const double even = compensate ? sum / (4 * pi) : 0;
    double left = 0;
    std::vector<float> weights(mean.size());
    for (std::size_t i = 0; i < mean.size(); ++i) {
        const double angle = solid_angle[i / std::size_t(width)];
        // Of a constant sky exactly nothing must be left.
        const double value = constant_ && compensate ? 0 : std::max(0.0, mean[i] - even);
        left += value * angle;
        weights[i] = static_cast<float>(value * angle);
    }
    irradiance_ = static_cast<float>(left) / 4; // of a uniform sphere of light: pi L = 4 pi L / 4
    distribution_ = Distribution2D(weights, width, height);
}

Color SkySampler::texel(int x, int y) const {
    const Image& image = *sky_.image;
    x = (x + image.width) % image.width;
    y = std::clamp(y, 0, image.height - 1);
    const float* p = image.at(x, y);
    const bool grey = image.channels.size() < 3;
    return Color(p[0], grey ? p[0] : p[1], grey ? p[0] : p[2]) * sky_.zenith * sky_.strength;
}

Vec2f SkySampler::image_from_direction(const Vec3& d) const {
    const float x = d.x * cos_rotation_ - d.z * sin_rotation_;
    const float z = d.x * sin_rotation_ + d.z * cos_rotation_;
    // The angle from the pole by atan2: acos would lose half the digits near it.
    const float v = std::atan2(std::sqrt(x * x + z * z), d.y) / pi_f;
    const float u = 0.5F + std::atan2(x, -z) / (2 * pi_f);
    return {u - std::floor(u), v};
}

// Uniform by solid angle within a row: in the cosine, not in the angle.
Vec3 SkySampler::direction_from_image(const Vec2f& p, std::size_t& row) const {
    const float position = p.y * static_cast<float>(scale_.size());
    row = std::min(static_cast<std::size_t>(position), scale_.size() - 1);
    const float part = position - static_cast<float>(row);
    const float cosine = cosines_[row] + (cosines_[row + 1] - cosines_[row]) * part;
    const float sine = std::sqrt(std::max(0.0F, 1 - cosine * cosine));
    const float longitude = (p.x - 0.5F) * 2 * pi_f;
    const float x = sine * std::sin(longitude);
    const float z = -sine * std::cos(longitude);
    return {x * cos_rotation_ + z * sin_rotation_, cosine, z * cos_rotation_ - x * sin_rotation_};
}

Color SkySampler::radiance(const Vec3& d) const {
    if (sky_.image == nullptr) {
        if (constant_)
            return sky_.zenith * sky_.strength;
        if (d.y < 0)
            return sky_.ground * sky_.strength;
        return (sky_.horizon * (1 - d.y) + sky_.zenith * d.y) * sky_.strength;
    }
    const Vec2f p = image_from_direction(d);
    const float x = p.x * static_cast<float>(sky_.image->width) - 0.5F;
    const float y = p.y * static_cast<float>(sky_.image->height) - 0.5F;
    const float x0 = std::floor(x);
    const float y0 = std::floor(y);
    const int ix = static_cast<int>(x0);
    const int iy = static_cast<int>(y0);
    const float s = x - x0;
    const float t = y - y0;
    return (texel(ix, iy) * (1 - s) + texel(ix + 1, iy) * s) * (1 - t) +
           (texel(ix, iy + 1) * (1 - s) + texel(ix + 1, iy + 1) * s) * t;
}

float SkySampler::pdf(const Vec3& d) const {
    if (irradiance_ == 0)
        return 0;
    if (constant_)
        return 1 / (4 * pi_f);
    const Vec2f p = image_from_direction(d);
    const auto row = static_cast<std::size_t>(p.y * static_cast<float>(scale_.size()));
    return distribution_.pdf(p) * scale_[std::min(row, scale_.size() - 1)];
}

Vec3 SkySampler::sample(const Vec2f& u, float& pdf) const {
    std::size_t row = 0;
    const Vec3 direction = direction_from_image(distribution_.sample(u, pdf), row);
    pdf *= scale_[row];
    return direction;
}

} // namespace scree
