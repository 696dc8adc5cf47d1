// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/tile_noise.h"

#include "core/random.h"

namespace scree {

namespace {

// The standard deviation of gradient noise with unit gradients is 0.24 over the unit square
// (measured over 10^6 points of 16 lattices).
constexpr float gain = 1.0F / (3 * 0.24F);

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); } // Perlin 2002

} // namespace

TileNoise::TileNoise(int columns, int rows, std::uint64_t seed, std::uint64_t stream)
    : columns_(columns), rows_(rows) {
    gradients_.reserve(std::size_t(columns) * std::size_t(rows));
    for (std::uint64_t i = 0; i < std::uint64_t(columns) * std::uint64_t(rows); ++i) {
        Random random(seed, Purpose::leather_noise, (stream << 40) | i);
        const double angle = random.uniform(0, 2 * pi);
        gradients_.emplace_back(static_cast<float>(std::cos(angle)),
                                static_cast<float>(std::sin(angle)));
    }
}

float TileNoise::operator()(const Vec2& uv) const {
    const double x = (uv.x - std::floor(uv.x)) * columns_;
    const double y = (uv.y - std::floor(uv.y)) * rows_;
    const int x0 = static_cast<int>(x) % columns_, y0 = static_cast<int>(y) % rows_;
    const int x1 = (x0 + 1) % columns_, y1 = (y0 + 1) % rows_;
    const auto tx = static_cast<float>(x - std::floor(x));
    const auto ty = static_cast<float>(y - std::floor(y));
    const auto corner = [&](int i, int j, float dx, float dy) {
        const Vec2f& g = gradients_[std::size_t(j) * std::size_t(columns_) + std::size_t(i)];
        return g.x * dx + g.y * dy;
    };
    const float a = corner(x0, y0, tx, ty), b = corner(x1, y0, tx - 1, ty);
    const float c = corner(x0, y1, tx, ty - 1), d = corner(x1, y1, tx - 1, ty - 1);
    const float u = fade(tx), v = fade(ty);
    const float low = a + u * (b - a), high = c + u * (d - c);
    return gain * (low + v * (high - low));
}

TileFractal::TileFractal(int columns, int rows, int octaves, std::uint64_t seed,
                         std::uint64_t stream) {
    for (int i = 0; i < octaves; ++i)
        octaves_.emplace_back(columns << i, rows << i, seed, stream * 16 + std::uint64_t(i));
}

float TileFractal::operator()(const Vec2& uv) const {
    float sum = 0, height = 1;
    for (const TileNoise& octave : octaves_) {
        sum += height * octave(uv);
        height /= 2;
    }
    return sum;
}

} // namespace scree
