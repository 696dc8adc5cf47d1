// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/film/denoise.h"

#include "render/film/denoise_noise.h"
#include "render/film/denoise_vector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scree {

namespace {

// Added to the albedo that light is divided by, so that dark surfaces do not magnify reflections.
constexpr float least_albedo = 0.1F;
// Its square, and that of differences, are finite.
constexpr float most_light = 1e15F;

float light_of(float radiance, float albedo) {
    return std::min(most_light, radiance / (std::max(0.0F, albedo) + least_albedo));
}

// Of two means of n and m values, the square of the difference times this is the variance of the
// mean of all.
float share_of_variance(const Film::Halves& halves) {
    const float all = static_cast<float>(halves.all.samples);
    return static_cast<float>(halves.first.samples) / all *
           (static_cast<float>(halves.rest.samples) / all);
}

float squared_difference(const Vec3& a, const Vec3& b) { return (a - b).length2(); }

struct Layers {
    Layers(int width, int height)
        : light(width, height, layer_planes), albedo(width, height, layer_planes),
          normal(width, height, layer_planes), trust(width, height, 1),
          noise(width, height, noise_planes) {}

    Planes light;
    Planes albedo;
    Planes normal;
    Planes trust;
    Planes noise;
};

void take_pixel(const Film::Halves& halves, int x, int y, Layers& layers) {
    if (halves.all.samples == 0)
        return;
    *layers.trust.at(0, x, y) = 1;
    for (int c = 0; c < 3; ++c) {
        *layers.light.at(c, x, y) = light_of(halves.all.radiance[c], halves.all.albedo[c]);
        *layers.albedo.at(c, x, y) = std::clamp(halves.all.albedo[c], 0.0F, most_light);
        *layers.normal.at(c, x, y) = halves.all.normal[c];
    }
    if (halves.first.samples == 0) {
        *layers.noise.at(noise_of_halves, x, y) = noise_unknown;
        return;
    }
    float difference = 0;
    float variance = 0;
    for (int c = 0; c < 3; ++c) {
        const float gap = light_of(halves.first.radiance[c], halves.first.albedo[c]) -
                          light_of(halves.rest.radiance[c], halves.rest.albedo[c]);
        difference += gap * gap / 3;
        const float scale = 1 / (std::max(0.0F, halves.all.albedo[c]) + least_albedo);
        variance += std::min(most_light, std::sqrt(halves.variance[c]) * scale) *
                    std::min(most_light, std::sqrt(halves.variance[c]) * scale) / 3;
    }
    const float share = share_of_variance(halves);
    *layers.noise.at(noise_of_halves, x, y) = difference * share;
    *layers.noise.at(noise_of_samples, x, y) = variance;
    *layers.albedo.at(layer_variance, x, y) =
        share / 3 * squared_difference(halves.first.albedo, halves.rest.albedo);
    *layers.normal.at(layer_variance, x, y) =
        share / 3 * squared_difference(halves.first.normal, halves.rest.normal);
}

// Features by NL-means of themselves, where depth of field or edges leave noise in them.
void smooth_features(Planes& layer, const Planes& trust) {
    pool_variance(layer);
    for (int plane = 0; plane < layer_planes; ++plane)
        layer.extend(plane);
    Planes smooth(layer.width(), layer.height(), 3);
    layer.for_tiles([&](int x, int y) { smooth_tile(layer, trust, smooth, x, y); });
    layer.for_rows([&](int y) {
        for (int c = 0; c < 3; ++c)
            std::copy_n(smooth.at(c, 0, y), layer.width(), layer.at(c, 0, y));
    });
    for (int c = 0; c < 3; ++c)
        layer.extend(c);
}

} // namespace

Image denoise(const Film& film) {
    const int width = film.width();
    const int height = film.height();
    Layers layers(width, height);
    layers.light.for_rows([&](int y) {
        for (int x = 0; x < width; ++x)
            take_pixel(film.halves(x, y), x, y, layers);
    });
    find_noise(layers.light, layers.noise);
    for (int plane = 0; plane < layer_planes; ++plane)
        layers.light.extend(plane);
    smooth_features(layers.albedo, layers.trust);
    smooth_features(layers.normal, layers.trust);

    Planes fitted(width, height, 3);
    const DenoiseLayers ready{layers.light, layers.albedo, layers.normal, layers.trust};
    fitted.for_tiles([&](int x, int y) { fit_tile(ready, fitted, x, y); });

    Image picture = film.beauty();
    fitted.for_rows([&](int y) {
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3 && film.samples(x, y) > 0; ++c) {
                const float light = *fitted.at(c, x, y);
                picture.at(x, y)[c] = light * (*layers.albedo.at(c, x, y) + least_albedo);
            }
    });
    return picture;
}

} // namespace scree
