// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/film/denoise_noise.h"

#include "render/film/denoise_vector.h"

#include <array>
#include <cmath>

namespace scree {

namespace {

constexpr int scale_radius = 10; // variances of 441 pixels are compared
constexpr int pool_radius = 1;
constexpr int outlier_radius = 2;

// Mean over the square of pixels around each one, as far as it lies in the picture.
void box_mean(Planes& planes, int plane, int radius) {
    const int width = planes.width();
    const int height = planes.height();
    Planes rows(width, height, 1);
    planes.for_rows([&](int y) {
        for (int x = 0; x < width; ++x) {
            const int first = std::max(0, x - radius);
            const int last = std::min(width - 1, x + radius);
            float sum = 0;
            for (int i = first; i <= last; ++i)
                sum += *planes.at(plane, i, y);
            *rows.at(0, x, y) = sum / static_cast<float>(last - first + 1);
        }
    });
    planes.for_rows([&](int y) {
        const int first = std::max(0, y - radius);
        const int last = std::min(height - 1, y + radius);
        float* to = planes.at(plane, 0, y);
        std::fill_n(to, width, 0.0F);
        for (int j = first; j <= last; ++j)
            for (int x = 0; x < width; ++x)
                to[x] += *rows.at(0, x, j);
        for (int x = 0; x < width; ++x)
            to[x] /= static_cast<float>(last - first + 1);
    });
}

float brightness(const Planes& light, int x, int y) {
    return *light.at(0, x, y) + *light.at(1, x, y) + *light.at(2, x, y);
}

/// The pixels of a square around one, as far as they lie in the picture: calls body(x, y).
template <class Body>
void around(const Planes& planes, int x, int y, int radius, const Body& body) {
    for (int j = std::max(0, y - radius); j <= std::min(planes.height() - 1, y + radius); ++j)
        for (int i = std::max(0, x - radius); i <= std::min(planes.width() - 1, x + radius); ++i)
            body(i, j);
}

// Variance of light among the pixels around, in the mean over channels.
float variance_around(const Planes& light, int x, int y) {
    double sum[3] = {};
    double squares = 0;
    double count = 0;
    around(light, x, y, pool_radius, [&](int i, int j) {
        for (int c = 0; c < 3; ++c) {
            const double value = *light.at(c, i, j);
            sum[c] += value;
            squares += value * value;
        }
        ++count;
    });
    for (const double channel : sum)
        squares -= channel * channel / count;
    return static_cast<float>(std::max(0.0, squares) / (3 * std::max(1.0, count - 1)));
}

void fill_unknown(const Planes& light, Planes& noise) {
    noise.for_rows([&](int y) {
        for (int x = 0; x < noise.width(); ++x)
            if (*noise.at(noise_of_halves, x, y) == noise_unknown) {
                const float variance = variance_around(light, x, y);
                *noise.at(noise_of_halves, x, y) = variance;
                *noise.at(noise_of_samples, x, y) = variance;
            }
    });
}

// By how much an uncertain pixel is to be dimmed: to the brightness that 15% of those around it
// reach. 1 for others.
float dimmed(const Planes& light, float variance, int x, int y) {
    constexpr float uncertain = 0.4F; // standard deviation over the mean
    constexpr float reached = 0.85F;
    const float here = brightness(light, x, y);
    if (!(std::sqrt(variance) > uncertain * here / 3))
        return 1;
    constexpr std::size_t side = 2 * outlier_radius + 1;
    std::array<float, side * side> others;
    std::size_t count = 0;
    around(light, x, y, outlier_radius, [&](int i, int j) {
        if (i != x || j != y)
            others[count++] = brightness(light, i, j);
    });
    if (count == 0)
        return 1;
    const auto bright = others.begin() + std::ptrdiff_t(reached * static_cast<float>(count));
    std::nth_element(others.begin(), bright, others.begin() + std::ptrdiff_t(count));
    return here > *bright ? *bright / here : 1;
}

} // namespace

void pool_variance(Planes& layer) { box_mean(layer, layer_variance, pool_radius); }

void find_noise(Planes& light, Planes& noise) {
    fill_unknown(light, noise);
    Planes around = noise;
    box_mean(around, noise_of_halves, scale_radius);
    box_mean(around, noise_of_samples, scale_radius);
    const auto each = [&](const auto& body) {
        noise.for_rows([&](int y) {
            for (int x = 0; x < noise.width(); ++x)
                body(x, y);
        });
    };
    Planes& scaled = noise;
    each([&](int x, int y) {
        const float halves = *around.at(noise_of_halves, x, y);
        const float samples = *around.at(noise_of_samples, x, y);
        const float scale = halves < samples ? halves / samples : 1;
        *scaled.at(noise_of_samples, x, y) *= scale;
        *light.at(layer_variance, x, y) = *scaled.at(noise_of_samples, x, y);
    });
    pool_variance(light);

    Planes dim(noise.width(), noise.height(), 1);
    each([&](int x, int y) {
        *dim.at(0, x, y) = dimmed(light, *scaled.at(noise_of_samples, x, y), x, y);
    });
    each([&](int x, int y) {
        // What a pixel has more noise than those around, it has itself.
        float& variance = *light.at(layer_variance, x, y);
        const float factor = *dim.at(0, x, y);
        variance = std::max(variance, *scaled.at(noise_of_samples, x, y)) * factor * factor;
        for (int c = 0; c < 3; ++c)
            *light.at(c, x, y) *= factor;
    });
}

} // namespace scree
