// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/lichen.h"

#include "geometry/rock/solid_noise.h"

#include <algorithm>

namespace scree {

namespace {

constexpr int layers = 3;
constexpr double next_size = 0.45;      // of a layer, of that before
constexpr int places_of_cell = 2;       // in a cube as wide as the largest crust of its layer
constexpr double least_radius = 0.3;    // of a crust, in sides of the cube
constexpr double greatest_radius = 0.5; // so that a crust reaches into neighbours only
constexpr double raggedness = 0.35;     // of a border, in radii
constexpr double rim = 0.25;            // its width, in radii
constexpr double thickness = 0.01;      // of a crust, in radii

/// The mean volume of a ball, in cubes.
double mean_volume() {
    const double fourths = std::pow(greatest_radius, 4) - std::pow(least_radius, 4);
    return 4.0 / 3 * pi * fourths / (4 * (greatest_radius - least_radius));
}

double share(std::uint32_t bits) { return (bits & 0xFFFFU) / 65536.0; }

} // namespace

Lichen::Lichen(double cover, double size, std::uint32_t seed) : size_(size), seed_(seed) {
    // Balls with independent places leave a point bare with the probability exp(-volume per
    // volume), the product of those of the layers.
    const double each = -std::log(1 - std::min(cover, most_cover)) / layers;
    chance_ = each / (places_of_cell * mean_volume());
    layer_cover_ = 1 - std::exp(-each);
}

Lichen::Seen Lichen::layer(const WideVec3& position, double width, double exposure, double spacing,
                           std::uint32_t seed) const {
    const WideVec3 p = position / spacing;
    const WideVec3 corner(std::floor(p.x - 0.5), std::floor(p.y - 0.5), std::floor(p.z - 0.5));
    const double ragged = gradient_noise(p * 5.0, seed) + 0.5 * gradient_noise(p * 13.0, seed + 1);
    Seen best;
    double inside = -1; // how far in a crust, in radii
    for (int i = 0; i < 8 * places_of_cell; ++i) {
        const WideVec3 cell = corner + WideVec3(i & 1, i >> 1 & 1, i >> 2 & 1);
        const std::uint32_t hash = lattice_hash(int(cell.x), int(cell.y), int(cell.z),
                                                seed + static_cast<std::uint32_t>(i >> 3));
        const std::uint32_t more = lattice_hash(int(hash & 0xFFFFU), int(hash >> 16), 0, seed);
        if (share(more) >= chance_)
            continue;
        const std::uint32_t last = lattice_hash(int(more & 0xFFFFU), int(more >> 16), 1, seed);
        const WideVec3 middle = cell + WideVec3(share(hash), share(hash >> 16), share(more >> 16));
        const double radius =
            (least_radius + (greatest_radius - least_radius) * share(last)) * exposure;
        const WideVec3 off = p - middle;
        const double far = off.length();
        const double depth = radius > 0 ? 1 - far / radius + raggedness * ragged : -1;
        if (depth <= inside)
            continue;
        inside = depth;
        const double edge = depth * radius * spacing / std::max(width, 1e-9);
        best.cover = static_cast<float>(std::clamp(0.5 + edge, 0.0, 1.0));
        best.hue = static_cast<float>(share(last >> 16));
        const double in_rim = std::clamp(1 - depth / rim, 0.0, 1.0);
        best.shade = static_cast<float>(0.85 + 0.3 * in_rim);
        if (depth > 0 && depth < rim && far > 0)
            best.slope = Vec3(off * (-thickness / (rim * far)));
    }
    // Crusts too small to be seen one by one are their mean.
    const double blurred = std::clamp(2 * width / spacing - 0.5, 0.0, 1.0);
    const double mean = layer_cover_ * exposure * exposure * exposure;
    best.cover = static_cast<float>(mix(double(best.cover), mean, blurred));
    best.shade = static_cast<float>(mix(double(best.shade), 1.0, blurred));
    best.hue = static_cast<float>(mix(double(best.hue), 0.5, blurred));
    best.slope *= static_cast<float>(1 - blurred);
    return best;
}

Lichen::Seen Lichen::at(const Vec3& position, float width, float exposure) const {
    Seen seen;
    if (exposure <= 0)
        return seen;
    double spacing = size_;
    for (int k = 0; k < layers; ++k) {
        const Seen over = layer(WideVec3(position), double(width), double(exposure), spacing,
                                seed_ + 16 * static_cast<std::uint32_t>(k));
        const float below = seen.cover * (1 - over.cover);
        const float all = below + over.cover;
        if (all > 0) {
            const float by = over.cover / all;
            seen.shade += (over.shade - seen.shade) * by;
            seen.hue += (over.hue - seen.hue) * by;
        }
        seen.slope = seen.slope * (1 - over.cover) + over.slope * over.cover;
        seen.cover = all;
        spacing *= next_size;
    }
    return seen;
}

} // namespace scree
