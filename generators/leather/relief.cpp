// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/relief.h"

#include "core/parallel.h"
#include "core/random.h"
#include "generators/leather/fine_detail.h"
#include "generators/leather/groove_network.h"
#include "generators/leather/membrane.h"
#include "generators/leather/tile_noise.h"

#include <algorithm>

namespace scree {

namespace {

// Streams of random numbers, so that no two uses of one seed share any.
enum Stream : std::uint64_t { main_cells, minor_cells, meander_x, meander_y, strength, fading };

/// Lattice cells of a noise whose waves are about `length` long.
int waves(double size, double length) {
    return std::clamp(static_cast<int>(std::lround(size / length)), 1, 4096);
}

float smooth_step(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

class Relief {
  public:
    Relief(const ReliefRequest& request, const Context& context)
        : request_(request), settings_(request.settings), context_(context) {}

    HeightField make(ReliefFacts* facts);

  private:
    CellLayout place_main_cells() const;
    CellLayout place_minor_cells() const;
    Warp meander(double cell, std::uint64_t stream) const;
    std::vector<float> cell_heights(const CellLayout& cells) const;
    float rounded_distance(const GrooveNetwork& network, std::size_t pixel) const;
    Vec2f overhang(const GrooveNetwork& network, int x, int y) const;
    template <class Height>
    void for_each_pixel(const Height& height) const;

    const ReliefRequest& request_;
    const LeatherSettings& settings_;
    const Context& context_;
};

CellLayout Relief::place_main_cells() const {
    const LeatherSettings& s = settings_;
    CellKind large{
        s.cell, s.cell_range, s.elongation, request_.direction, s.direction_spread, s.irregularity};
    std::vector<CellKind> kinds{large};
    if (s.gap_cell > 0) { // rounder than the large ones, and turned any way
        CellKind small = large;
        small.scale = {s.gap_cell * s.cell_range.low, s.gap_cell * s.cell_range.high};
        small.elongation = std::sqrt(s.elongation);
        small.direction_spread = pi;
        kinds.push_back(small);
    }
    return place_cells(request_.size, kinds, request_.seed, main_cells, context_);
}

CellLayout Relief::place_minor_cells() const {
    const CellKind kind{settings_.cell * settings_.minor_cell, {0.6, 1.5}, 1.25, 0, pi, 0.8};
    return place_cells(request_.size, {kind}, request_.seed, minor_cells, context_);
}

Warp Relief::meander(double cell, std::uint64_t stream) const {
    if (settings_.meander <= 0)
        return nullptr;
    const int n = waves(request_.size, 1.1 * cell);
    const double size = request_.size, length = settings_.meander * cell;
    return [x = TileFractal(n, n, 2, request_.seed, 4 * stream + meander_x),
            y = TileFractal(n, n, 2, request_.seed, 4 * stream + meander_y), size,
            length](const Vec2& p) {
        const Vec2 uv = p / size;
        return p + Vec2(x(uv), y(uv)) * length;
    };
}

/// Of every cell's top, relative to the depth: larger cells stand higher, as pebbles do.
std::vector<float> Relief::cell_heights(const CellLayout& cells) const {
    std::vector<float> heights;
    for (std::size_t i = 0; i < cells.cells.size(); ++i) {
        const Cell& cell = cells.cells[i];
        Random random(request_.seed, Purpose::leather_height, i);
        const double width =
            2 * std::sqrt(cells.shapes[cell.shape].area() / pi) * cell.pose.scale / settings_.cell;
        heights.push_back(
            static_cast<float>(std::sqrt(std::min(1.0, width)) *
                               (1 + settings_.height_variation * random.uniform(-1, 1))));
    }
    return heights;
}

/// Distance to the groove, less where it meets others, so that round cells have round corners: the
/// smooth minimum of the distances to both (Quilez' polynomial one), which is C1 where they swap.
float Relief::rounded_distance(const GrooveNetwork& network, std::size_t pixel) const {
    const float d = network.distance[pixel], j = network.junction[pixel];
    const auto rounding =
        static_cast<float>(0.4 * settings_.roundness * settings_.roundness * settings_.cell);
    const float near = std::max(0.0F, rounding - (j - d));
    return rounding > 0 ? std::max(0.0F, d - near * near / (4 * rounding)) : d;
}

/// How far the shoulder leans over the groove: away from the cell's middle, not at the groove
/// itself, so that it never passes it: x exp(1 - x) has slope e at 0.
Vec2f Relief::overhang(const GrooveNetwork& network, int x, int y) const {
    const int n = network.resolution;
    const std::size_t here = network.index(x, y);
    const auto slope = [&](std::size_t before, std::size_t after) {
        const bool has_before = network.owner[before] == network.owner[here];
        const bool has_after = network.owner[after] == network.owner[here];
        return (network.distance[has_after ? after : here] -
                network.distance[has_before ? before : here]) *
               (has_before && has_after ? 0.5F : 1.0F);
    };
    const Vec2f gradient(slope(network.index((x + n - 1) % n, y), network.index((x + 1) % n, y)),
                         slope(network.index(x, (y + n - 1) % n), network.index(x, (y + 1) % n)));
    const float length = gradient.length();
    if (length == 0)
        return {0.0F, 0.0F};
    const float t = network.distance[here] / static_cast<float>(settings_.groove_width);
    const auto reach = static_cast<float>(settings_.overhang * settings_.groove_width);
    return gradient * (-reach * t * std::exp(1 - t) / length);
}

template <class Height>
void Relief::for_each_pixel(const Height& height) const {
    const int n = request_.resolution;
    parallel_for(std::size_t(n), 8, [&](std::size_t row) {
        for (int x = 0; x < n; ++x)
            height(x, int(row), Vec2((x + 0.5) / n, (double(row) + 0.5) / n));
    });
    context_.check_cancel();
}

HeightField Relief::make(ReliefFacts* facts) {
    const LeatherSettings& s = settings_;
    const bool has_cristae = request_.parts != ReliefParts::sulci;
    const bool has_sulci = request_.parts != ReliefParts::cristae;
    const auto f = [](double value) { return static_cast<float>(value); };

    const CellLayout cells = place_main_cells();
    const GrooveNetwork network =
        groove_network(cells, request_.resolution, meander(s.cell, 0), context_);
    std::vector<float> swell;
    std::vector<float> peak(cells.cells.size(), 1e-6F);
    if (has_cristae) {
        swell = membrane(network, s.cell * (0.04 + 0.5 * s.roundness * s.roundness), context_);
        for (std::size_t i = 0; i < swell.size(); ++i)
            peak[network.owner[i]] = std::max(peak[network.owner[i]], swell[i]);
    }
    GrooveNetwork minor;
    if (s.minor_cell > 0 && s.minor_depth > 0)
        minor = groove_network(place_minor_cells(), request_.resolution,
                               meander(s.cell * s.minor_cell, 1), context_);

    const bool is_vector = s.overhang > 0 && has_cristae;
    HeightField field;
    field.size = {request_.size, request_.size};
    field.image =
        Image(request_.resolution, request_.resolution,
              is_vector ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"});
    std::vector<float> heights(network.distance.size());
    const std::vector<float> tops = cell_heights(cells);
    const int n_strength = waves(request_.size, 1.7 * s.cell);
    const TileFractal strength_noise(n_strength, n_strength, 2, request_.seed, strength);
    const int n_fading = waves(request_.size, 0.8 * s.cell);
    const TileNoise fading_noise(n_fading, n_fading, request_.seed, fading);

    for_each_pixel([&](int x, int y, const Vec2& uv) {
        const std::size_t i = network.index(x, y);
        // Some grooves are shallow, as if two cells had grown together: there the base rises.
        const float depth =
            1 - f(s.groove_variation) * smooth_step(-0.1F, 0.75F, strength_noise(uv));
        const float groove = sulcus_profile(rounded_distance(network, i), f(s.groove_width));
        float height = 0;
        float crown = 0;
        if (has_cristae) {
            const float swollen = swell[i] / peak[network.owner[i]];
            crown = crista_profile(swollen, f(s.fullness)) * (1 - groove);
            const float top = crown * tops[network.owner[i]] * (1 + f(s.tilt) * network.along[i]);
            height += f(s.depth) * (1 - depth * (1 - top));
        }
        if (has_sulci)
            height -= f(s.groove_depth) * depth * groove;
        if (has_sulci && !minor.distance.empty()) {
            // Minor grooves branch off the main ones and fade out on some tops.
            const float fade = smooth_step(-0.55F, 0.35F, fading_noise(uv)) * (1 - groove);
            const float spacing = f(s.cell * s.minor_cell);
            height -= f(s.minor_depth) * fade *
                      (0.55F * sulcus_profile(minor.distance[i], 0.16F * spacing) +
                       0.45F * std::exp(-minor.distance[i] / (0.2F * spacing)));
        }
        heights[i] = height;
        if (is_vector) {
            const Vec2f sideways = overhang(network, x, y);
            field.image.pixels[3 * i] = sideways.x;
            field.image.pixels[3 * i + 2] = sideways.y;
        }
    });
    std::size_t pores = 0;
    if (request_.parts == ReliefParts::both)
        pores = add_fine_detail({s, request_.size, request_.direction, request_.seed}, network,
                                heights, context_);
    for (std::size_t i = 0; i < heights.size(); ++i)
        field.image.pixels[is_vector ? 3 * i + 1 : i] = heights[i];
    if (facts != nullptr) {
        const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
        *facts = {cells.cells.size(), cells.fill(), pores, *lowest, *highest};
    }
    return field;
}

} // namespace

float crista_profile(float swell, float fullness) {
    const float rest = 1 - swell;
    const float parabola = 1 - rest * rest; // slope 2 at the groove, 0 at the top
    return parabola + fullness * (std::sqrt(std::max(0.0F, parabola)) - parabola);
}

float sulcus_profile(float distance, float width) {
    const float t = 2 * distance / width;
    return std::exp(-t * t);
}

HeightField leather_relief(const ReliefRequest& request, const Context& context,
                           ReliefFacts* facts) {
    return Relief(request, context).make(facts);
}

} // namespace scree
