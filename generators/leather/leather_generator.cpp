// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/leather_generator.h"

#include "core/random.h"
#include "generators/leather/displaced_surface.h"
#include "generators/leather/relief.h"

#include <fmt/format.h>

#include <chrono>

namespace scree {

namespace {

// Fewer cells than these across a tile would show that it repeats, and a cell could meet itself.
constexpr double least_cells = 5;
constexpr double most_cells = 1000;

ReliefParts parts_of(const Params& params) {
    const std::string& name = params.text("parts");
    return name == "cristae" ? ReliefParts::cristae
           : name == "sulci" ? ReliefParts::sulci
                             : ReliefParts::both;
}

ReliefRequest request_from(const Params& params) {
    ReliefRequest request;
    request.settings = settings_from(params);
    request.size = params.number("size");
    request.resolution = static_cast<int>(params.integer("resolution"));
    request.direction = params.number("direction");
    request.parts = parts_of(params);
    request.seed = static_cast<std::uint64_t>(params.integer("seed"));
    const LeatherSettings& s = request.settings;
    if (request.resolution % 2 != 0)
        throw params.error("resolution",
                           fmt::format("is odd, {}; expected an even number", request.resolution));
    const double across = request.size / (s.cell * s.cell_range.high);
    if (across < least_cells)
        throw params.error(
            params.has("cell") ? "cell" : "size",
            fmt::format("cells of up to {:.4g} mm are too large for a tile of {:.4g} mm",
                        s.cell * s.cell_range.high * 1e3, request.size * 1e3),
            fmt::format("at least {} of the largest must fit along the edge", least_cells));
    double smallest = s.cell * s.cell_range.low;
    if (s.minor_cell > 0 && s.minor_depth > 0)
        smallest = std::min(smallest, s.cell * s.minor_cell);
    if (request.size / smallest > most_cells)
        throw params.error(
            params.has("cell") ? "cell" : "size",
            fmt::format("cells of down to {:.4g} mm are too small for a tile of {:.4g} mm",
                        smallest * 1e3, request.size * 1e3),
            fmt::format("at most {} of the smallest may fit along the edge", most_cells));
    return request;
}

Mesh shape_of(const Params& params, const HeightField& field) {
    const auto triangles = static_cast<std::size_t>(params.integer("triangles"));
    if (!params.has("shape"))
        return displaced_swatch(field, params.number("thickness"), triangles);
    const Mesh& mesh = *params.object<Mesh>("shape");
    Vec3 centre;
    double radius = 0;
    Mesh result;
    if (is_sphere(mesh, centre, radius)) {
        const Vec3& facing = params.vector3("facing");
        if (!(facing.length() > 0))
            throw params.error("facing", "is no direction");
        result = displaced_sphere(field, centre, radius, facing, triangles);
    } else {
        if (mesh.uvs.empty())
            throw params.error("shape", mesh.name + " has no UVs to lay the leather on");
        result = displaced_mesh(field, mesh, triangles);
    }
    result.name = mesh.name;
    return result;
}

Matrix place_of(const Params& params) {
    const Vec3& turn = params.vector3("rotation");
    Matrix about_x, about_y, about_z, move;
    about_x.setAxisAngle(Vec3(1, 0, 0), turn.x);
    about_y.setAxisAngle(Vec3(0, 1, 0), turn.y);
    about_z.setAxisAngle(Vec3(0, 0, 1), turn.z);
    move.setTranslation(params.vector3("position"));
    return about_x * about_y * about_z * move;
}

Aggregate bake_leather(const Params& params, const Context& context) {
    const auto start = std::chrono::steady_clock::now();
    const ReliefRequest request = request_from(params);
    ReliefFacts facts;
    const auto field =
        std::make_shared<const HeightField>(leather_relief(request, context, &facts));
    const auto mesh = std::make_shared<const Mesh>(shape_of(params, *field));

    Aggregate aggregate;
    aggregate.generator = "leather";
    aggregate.seed = request.seed;
    aggregate.prototypes.push_back(
        {mesh->name, mesh, nullptr, params.object<Material>("material")});
    Instance instance;
    instance.world_from_object = place_of(params);
    instance.random = Random(request.seed, Purpose::instance_attribute).uniform_float();
    aggregate.instances.push_back(instance);
    aggregate.height = field;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    aggregate.facts = {
        {"cells", double(facts.cells)},     {"fill", facts.fill},
        {"pores", double(facts.pores)},     {"lowest", double(facts.lowest)},
        {"highest", double(facts.highest)}, {"triangles", double(mesh->triangles.size())},
        {"seconds", seconds.count()}};
    return aggregate;
}

std::vector<ParamSpec> leather_specs() {
    std::vector<ParamSpec> specs = leather_setting_specs();
    const std::vector<ParamSpec> tile{
        {.name = "size",
         .type = ParamType::number,
         .doc = "Edge of the square tile that the map covers.",
         .unit = "m",
         .fallback = 0.05,
         .min = 1e-4,
         .max = 100.0},
        {.name = "resolution",
         .type = ParamType::integer,
         .doc = "Pixels along the edge; an even number.",
         .unit = "pixels",
         .fallback = std::int64_t{1024},
         .min = 16.0,
         .max = 8192.0},
        {.name = "direction",
         .type = ParamType::number,
         .doc = "Direction of the cells' long axes, from +x towards +z of the flat map.",
         .unit = "deg",
         .fallback = 0.0,
         .min = -360.0,
         .max = 360.0},
        {.name = "parts",
         .type = ParamType::choice,
         .doc = "cristae: the raised cells alone; sulci: the grooves alone; both: the leather.",
         .fallback = std::string("both"),
         .choices = {"both", "cristae", "sulci"}},
        {.name = "seed",
         .type = ParamType::integer,
         .doc = "Another seed, another leather.",
         .fallback = std::int64_t{0},
         .min = 0.0},
    };
    const std::vector<ParamSpec> cover{
        {.name = "shape",
         .type = ParamType::object,
         .families = {"mesh"},
         .doc = "What the leather covers: a mesh with UVs, over which the tile repeats at its true "
                "size, or a sphere; one flat tile when not given.",
         .optional = true},
        {.name = "facing",
         .type = ParamType::vector3,
         .doc = "Of a sphere: the side from which it is seen; all distortion is at its back.",
         .fallback = Vec3(0, 0, 1)},
        {.name = "thickness",
         .type = ParamType::number,
         .doc = "Of a flat tile: its base plane lies at this height and has cut edges; 0: none.",
         .unit = "m",
         .fallback = 0.0,
         .min = 0.0,
         .max = 10.0},
        {.name = "triangles",
         .type = ParamType::integer,
         .doc = "About how many triangles the displaced shape has.",
         .fallback = std::int64_t{2000000},
         .min = 100.0,
         .max = 5e7},
        material_spec("Its material"),
        {.name = "position",
         .type = ParamType::vector3,
         .doc = "Where the shape's origin goes.",
         .unit = "m",
         .fallback = Vec3(0.0F)},
        {.name = "rotation",
         .type = ParamType::vector3,
         .doc = "Turn about the x axis, then y, then z, each through the shape's origin.",
         .unit = "deg",
         .fallback = Vec3(0.0F)},
    };
    specs.insert(specs.begin() + 1, tile.begin(), tile.end());
    specs.insert(specs.end(), cover.begin(), cover.end());
    return specs;
}

} // namespace

Plugin<Bake> leather_plugin() {
    return {
        "leather",
        "Leather: a relief of cristae and sulci that tiles seamlessly, as a height map and as a "
        "displaced shape (after Sakurai & Miyata 2014).",
        leather_specs(), bake_leather};
}

} // namespace scree
