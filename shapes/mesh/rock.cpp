// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/rock/rock.h"
#include "geometry/rock/rock_params.h"
#include "shapes/mesh/component.h"

namespace scree {

namespace {

Mesh rock(const Params& params) {
    RockSettings settings = rock_settings(params);
    settings.seed = static_cast<std::uint64_t>(params.integer("seed"));
    const int level = rock_level(double(params.integer("triangles")));
    Mesh mesh = rock_mesh(Rock(settings).vertices(level), level);
    const auto scale = static_cast<float>(params.number("size") / 2);
    for (Vec3& p : mesh.positions)
        p *= scale;
    return mesh;
}

} // namespace

Plugin<MakeMesh> rock_component() {
    std::vector<ParamSpec> specs{metres("size", "Length of the longest axis.", 0.1)};
    for (ParamSpec& spec : rock_specs())
        specs.push_back(std::move(spec));
    specs.push_back(rock_triangles_spec(
        "About how many triangles: 20 n^2 for a whole n. Relief that is finer than two edges is "
        "left out.",
        std::int64_t{5120}));
    specs.push_back({.name = "seed",
                     .type = ParamType::integer,
                     .doc = "Another seed, another rock.",
                     .fallback = std::int64_t{0},
                     .min = 0.0});
    return component(
        "rock",
        "A rock, its longest axis along x and its shortest upright. It does not rest: a "
        "plane at its foot touches it at one point; generator.rocks lays rocks down.",
        std::move(specs), rock);
}

} // namespace scree
