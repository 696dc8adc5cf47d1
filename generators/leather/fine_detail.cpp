// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/fine_detail.h"

#include "core/parallel.h"
#include "core/random.h"
#include "generators/leather/tile_noise.h"

#include <algorithm>
#include <numeric>

namespace scree {

namespace {

enum Stream : std::uint64_t { wrinkles = 64, wrinkle_bend, wrinkle_fade, grain, undulation };

int waves(double size, double length) {
    return std::clamp(static_cast<int>(std::lround(size / length)), 1, 4096);
}

/// The valley where the noise passes through zero: 1 in it, 0 away from it.
float valley(float noise, float width) {
    const float t = noise / width;
    return 1 / (1 + t * t);
}

/// Wrinkles, grain and undulation: sums of periodic noises, pixel by pixel.
void add_noises(const FineDetail& detail, int resolution, std::vector<float>& heights) {
    const LeatherSettings& s = detail.settings;
    const double size = detail.size;
    // Wrinkles run across the direction; the torus only takes whole numbers of waves, so the
    // stretch follows the nearer axis.
    const bool along_x =
        std::abs(std::cos(detail.direction)) >= std::abs(std::sin(detail.direction));
    const int narrow = waves(size, s.wrinkle_spacing), wide = waves(size, 1.6 * s.wrinkle_spacing);
    const TileFractal wrinkle(along_x ? narrow : wide, along_x ? wide : narrow, 2, detail.seed,
                              wrinkles);
    const int bend_waves = waves(size, 3 * s.wrinkle_spacing);
    const TileNoise bend(bend_waves, bend_waves, detail.seed, wrinkle_bend);
    const TileNoise fade(bend_waves, bend_waves, detail.seed, wrinkle_fade);
    const int grain_waves = waves(size, 6 * size / resolution);
    const TileFractal grains(grain_waves, grain_waves, 2, detail.seed, grain);
    const int long_waves = waves(size, s.cell * s.undulation_cells);
    const TileFractal long_wave(long_waves, long_waves, 3, detail.seed, undulation);
    const auto f = [](double value) { return static_cast<float>(value); };
    parallel_for(std::size_t(resolution), 8, [&](std::size_t row) {
        for (int x = 0; x < resolution; ++x) {
            const Vec2 uv((x + 0.5) / resolution, (double(row) + 0.5) / resolution);
            float height = 0;
            if (s.wrinkle_depth > 0) {
                const Vec2 bent =
                    uv + Vec2(bend(uv), bend({uv.y, uv.x})) * (0.8 * s.wrinkle_spacing / size);
                const float strength = std::clamp(0.55F + fade(uv), 0.0F, 1.0F);
                height -= f(s.wrinkle_depth) * strength * valley(wrinkle(bent), 0.14F);
            }
            if (s.roughness > 0)
                height += f(s.roughness) * grains(uv);
            if (s.undulation > 0)
                height += f(s.undulation) * long_wave(uv);
            heights[row * std::size_t(resolution) + std::size_t(x)] += height;
        }
    });
}

struct Pore {
    Vec2 centre;
    double angle = 0;
    double width = 0;
    double depth = 0;
};

/// Pores drawn from the pixels, those near junctions of grooves four times as often.
std::vector<Pore> draw_pores(const FineDetail& detail, const GrooveNetwork& network) {
    const LeatherSettings& s = detail.settings;
    const auto wanted =
        static_cast<std::size_t>(s.pore_density * (detail.size / s.cell) * (detail.size / s.cell));
    const auto near = static_cast<float>(0.1 * s.cell);
    std::vector<Pore> pores;
    for (std::uint64_t trial = 0; pores.size() < wanted && trial < 64 * wanted; ++trial) {
        Random random(detail.seed, Purpose::leather_pore, trial);
        const Vec2 at(random.uniform(0, detail.size), random.uniform(0, detail.size));
        const int x = std::min(network.resolution - 1, static_cast<int>(at.x / network.pixel));
        const int y = std::min(network.resolution - 1, static_cast<int>(at.y / network.pixel));
        const bool is_junction = network.junction[network.index(x, y)] < near;
        if (random.uniform() > (is_junction ? 1.0 : 0.25))
            continue;
        pores.push_back({at, detail.direction + 0.35 * random.uniform(-1, 1),
                         s.pore_width * random.uniform(0.7, 1.3),
                         s.pore_depth * random.uniform(0.4, 1.0)});
    }
    return pores;
}

/// A slanted pit, twice as long as wide, whose far side rises to a low lip where the hair leaned.
void stamp(const Pore& pore, const GrooveNetwork& network, std::vector<float>& heights) {
    const int n = network.resolution;
    const Vec2 axis(std::cos(pore.angle), std::sin(pore.angle));
    const double reach = 3 * pore.width;
    const int x0 = static_cast<int>(std::floor((pore.centre.x - reach) / network.pixel));
    const int y0 = static_cast<int>(std::floor((pore.centre.y - reach) / network.pixel));
    const int count = std::min(n, static_cast<int>(2 * reach / network.pixel) + 2);
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) {
            const Vec2 p =
                (Vec2(x0 + i + 0.5, y0 + j + 0.5) * network.pixel - pore.centre) / pore.width;
            const double u = p.dot(axis), v = cross(axis, p);
            const double pit = std::exp(-(u * u + 4 * v * v));
            const double lip = std::exp(-((u - 1.1) * (u - 1.1) * 3 + 3 * v * v));
            heights[network.index(((x0 + i) % n + n) % n, ((y0 + j) % n + n) % n)] +=
                static_cast<float>(pore.depth * (0.15 * lip - pit));
        }
}

} // namespace

std::size_t add_fine_detail(const FineDetail& detail, const GrooveNetwork& network,
                            std::vector<float>& heights, const Context& context) {
    add_noises(detail, network.resolution, heights);
    context.check_cancel();
    if (!(detail.settings.pore_density > 0 && detail.settings.pore_depth > 0))
        return 0;
    const std::vector<Pore> pores = draw_pores(detail, network);
    for (const Pore& pore : pores) // in order: they may lie over each other
        stamp(pore, network, heights);
    return pores.size();
}

} // namespace scree
