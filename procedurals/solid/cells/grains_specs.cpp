// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/cells/grains_specs.h"

#include "core/random.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// The inverse of the normal distribution function.
double normal_quantile(double share) {
    double low = -9, high = 9;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (std::erfc(-middle / std::numbers::sqrt2) / 2 < share ? low : high) = middle;
    }
    return low;
}

double lightness(const Color& c) {
    return 0.2126 * double(c.x) + 0.7152 * double(c.y) + 0.0722 * double(c.z);
}

/// Measures the shares of space beyond the gap from borders and within the radius, with and without
/// the rim.
void measure_outline(solid::GrainLayer& layer, std::uint32_t seed) {
    constexpr int points = 20000;
    Random random(seed, Purpose::solid_cell, 1000);
    int whole = 0, core = 0;
    for (int i = 0; i < points; ++i) {
        solid::CellView view{};
        view.place = {float(random.uniform(0, 1000)), float(random.uniform(0, 1000)),
                      float(random.uniform(0, 1000))};
        view.key = layer.cells.key;
        solid::Seeds seeds;
        const float depth = layer.gap + layer.rim;
        solid::gather_seeds(view, layer.cells.jitter, CELLS_REACH, depth, 0, &seeds);
        solid::Triple inwards;
        const float border = solid::border_distance(&seeds, depth, &inwards);
        const float away = solid::length_of(seeds.seed[0].away);
        const float inside = std::min(border - layer.gap, layer.radius - away);
        whole += inside >= 0 ? 1 : 0;
        core += inside >= layer.rim ? 1 : 0;
    }
    layer.whole = float(whole) / points;
    layer.core = float(core) / points;
}

solid::GrainKind make_kind(const Mineral& mineral, double roughness) {
    solid::GrainKind kind{};
    kind.color = as_triple(mineral.color);
    kind.roughness = as_float(std::min(1.0, roughness * mineral.gloss));
    kind.variation = as_float(mineral.variation);
    kind.facet = as_float(mineral.facet);
    kind.mottle = as_float(mineral.mottle);
    return kind;
}

solid::GrainLayer make_layer(const Params& params, const GrainRecipe& recipe, unsigned index,
                             double width, const solid::Lattice& lattice) {
    solid::GrainLayer layer{};
    layer.cells = make_cells(params, 10 + index, width, 1, recipe.jitter);
    Random random(layer.cells.key, Purpose::solid_cell, 2000);
    layer.cluster_offset = {random.uniform_float(), random.uniform_float(), random.uniform_float()};
    // Clusters are some grains wide: the lattice's cube is nine grains wide.
    layer.clusters = as_float(recipe.clusters);
    layer.cluster_scale = 1.0F / 9;
    layer.cluster_deviation = std::sqrt(std::max(
        1e-6F, lattice.residual_variance[0] - lattice.residual_variance[GRAINS_CLUSTER_LEVEL]));
    GrainOutline outline;
    if (index < recipe.outlines.size())
        outline = recipe.outlines[index];
    layer.gap = as_float(outline.gap);
    layer.gap_by_field = as_float(recipe.gap_by_field);
    layer.radius = as_float(outline.radius);
    layer.rim = as_float(outline.rim);
    layer.rim_share = as_float(outline.rim_share);
    layer.rim_color = as_triple(outline.rim_color);
    layer.whole = layer.core = 1;
    if (outline.gap >= 0)
        measure_outline(layer, layer.cells.key);
    return layer;
}

} // namespace

solid::Grains make_grains(const Params& params, const std::string& field, GrainRecipe recipe,
                          const solid::Lattice& lattice) {
    std::vector<Mineral>& minerals = recipe.minerals;
    if (minerals.size() > GRAINS_MAX_KINDS)
        throw params.error(field, "has more than 12 kinds");
    std::stable_sort(minerals.begin(), minerals.end(),
                     [](const Mineral& a, const Mineral& b) { return a.size > b.size; });
    double rest = 0, light = -1e9, dark = 1e9;
    for (const Mineral& mineral : minerals) {
        rest += mineral.share;
        light = std::max(light, lightness(mineral.color));
        dark = std::min(dark, lightness(mineral.color));
    }
    if (!recipe.whole) // shares are then of the whole stone
        rest = std::max(1.0, rest);
    solid::Grains grains{};
    double taken = 0, left = rest;
    for (std::size_t i = 0; i < minerals.size(); ++i) {
        const Mineral& mineral = minerals[i];
        if (i == 0 || mineral.size < minerals[i - 1].size) {
            if (grains.layers == GRAINS_MAX_LAYERS)
                throw params.error(field, "has more than 6 sizes");
            const auto index = static_cast<unsigned>(grains.layers);
            solid::GrainLayer& layer = grains.layer[grains.layers++];
            layer = make_layer(params, recipe, index, mineral.size, lattice);
            layer.first = layer.end = static_cast<int>(i);
            left = rest; // the share that larger grains leave to this size
            taken = 0;
        }
        solid::GrainLayer& layer = grains.layer[grains.layers - 1];
        solid::GrainKind& kind = grains.kind[layer.end++];
        kind = make_kind(mineral, recipe.roughness);
        kind.value = as_float((lightness(mineral.color) - dark) / std::max(1e-6, light - dark));
        taken += mineral.share;
        rest -= mineral.share;
        const bool last = recipe.whole && i + 1 == minerals.size();
        kind.until = last ? 100.0F : as_float(normal_quantile(std::min(1.0, taken / left)));
    }
    return grains;
}

ParamSpec minerals_spec(std::string name, std::string doc) {
    const auto number = [](const char* field, const char* text, double fallback, double max) {
        return ParamSpec{.name = field,
                         .type = ParamType::number,
                         .doc = text,
                         .fallback = fallback,
                         .min = 0.0,
                         .max = max};
    };
    return {.name = std::move(name),
            .type = ParamType::list,
            .doc = std::move(doc),
            .optional = true,
            .fields = {{.name = "color", .type = ParamType::color, .doc = "Its colour."},
                       {.name = "share",
                        .type = ParamType::number,
                        .doc = "Its share of the stone, relative to the others.",
                        .fallback = 1.0,
                        .min = 0.0,
                        .above_min = true},
                       preset_number("size", "Mean width of its grains.", "m", 1e-6, 1e4),
                       number("variation", "Of brightness from grain to grain.", 0.08, 1),
                       number("facet", "Of brightness across each grain.", 0.06, 1),
                       number("mottle", "Of brightness by the fractal field.", 0.03, 1),
                       number("gloss", "Factor of the stone's roughness.", 1, 10)},
            .min_items = 1};
}

std::vector<Mineral> minerals_of(const std::vector<Params>& list, double otherwise_size) {
    std::vector<Mineral> minerals;
    for (const Params& given : list)
        minerals.push_back({reflectance(given, "color"), given.number("share"),
                            number_or(given, "size", otherwise_size), given.number("variation"),
                            given.number("facet"), given.number("mottle"), given.number("gloss")});
    return minerals;
}

} // namespace scree
