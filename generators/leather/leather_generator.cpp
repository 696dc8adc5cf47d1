// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/leather_generator.h"

#include "core/random.h"
#include "generators/leather/displaced_surface.h"
#include "generators/leather/relief.h"
#include "generators/leather/tile_repeats.h"

#include <fmt/format.h>

#include <chrono>

namespace scree {

namespace {

// With fewer cells across a tile one would see that it repeats, and a cell could meet itself.
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

/// What the leather covers, and where that goes.
struct CoverSettings {
    std::shared_ptr<const Mesh> shape; // null: one flat tile
    Vec3 facing;                       // of a sphere
    double thickness = 0;              // of a flat tile [m]
    std::size_t triangles = 0;
    std::shared_ptr<const Material> material;
    WideVec3 position;
    Vec3 rotation; // about x, then y, then z [rad]

    ParamPlace shape_place;
    ParamPlace facing_place;
    ParamPlace triangles_place;
};

CoverSettings cover_from(const Params& params) {
    return {.shape = params.object<Mesh>("shape"),
            .facing = params.vector3("facing"),
            .thickness = params.number("thickness"),
            .triangles = static_cast<std::size_t>(params.integer("triangles")),
            .material = params.object<Material>("material"),
            .position = params.point3("position"),
            .rotation = params.vector3("rotation"),
            .shape_place = params.place("shape"),
            .facing_place = params.place("facing"),
            .triangles_place = params.place("triangles")};
}

/// Whether the shape is a sphere, whose place and size are set then.
bool covers_sphere(const CoverSettings& cover, Vec3& centre, double& radius) {
    return cover.shape != nullptr && is_sphere(*cover.shape, centre, radius);
}

void check(const CoverSettings& cover) {
    Vec3 centre;
    double radius = 0;
    if (covers_sphere(cover, centre, radius)) {
        if (!(cover.facing.length() > 0))
            throw cover.facing_place.error("is no direction");
    } else if (cover.shape != nullptr && cover.shape->uvs.empty()) {
        throw cover.shape_place.error(cover.shape->name + " has no UVs to lay the leather on");
    } else if (cover.shape != nullptr && cover.shape->triangles.size() > cover.triangles) {
        throw cover.triangles_place.error(fmt::format("is {}, but {} has {} already",
                                                      cover.triangles, cover.shape->name,
                                                      cover.shape->triangles.size()));
    }
}

// With more than this one sees that cells are drawn out or pressed together. Below the 1.5 of a box
// of 2 : 1 whose UVs fill each side, which rounding of its edges would else decide.
constexpr double visible_stretch = 1.49;

/// Warns where a whole number of tiles over the UVs are notably larger or smaller than asked for.
void warn_of_size(const Params& params, const Mesh& shape, double tile) {
    constexpr double notable = 1.1;
    const Vec2 laid = laid_size(shape, {tile, tile});
    const double factor = std::sqrt(laid.x * laid.y) / tile;
    if (factor < notable && 1 / factor < notable)
        return;
    params.warn("size",
                fmt::format("a whole number of tiles over the UVs of {} makes each {:.3g} x {:.3g} "
                            "mm, not {:.3g}, and its cells {:.2f} times as large",
                            shape.name, 1e3 * laid.x, 1e3 * laid.y, 1e3 * tile, factor),
                fmt::format("size = {:.3g} fits", factor * tile));
}

/// Warns where the shape's UVs do not let the tile keep its size and shape.
void warn_of_stretch(const Params& params, const CoverSettings& cover, double tile) {
    Vec3 centre;
    double radius = 0;
    if (cover.shape == nullptr || covers_sphere(cover, centre, radius))
        return;
    const double stretch = tile_stretch(*cover.shape, {tile, tile});
    const std::string& name = cover.shape->name;
    if (std::isinf(stretch))
        params.warn("shape",
                    "parts of " + name + " have UVs without area, where the leather is smeared",
                    "unwrap it in a modelling program");
    else if (stretch > visible_stretch)
        params.warn(
            "shape",
            fmt::format("the UVs of {} draw the leather out, or press it together, by a "
                        "factor of up to {:.2f}",
                        name, stretch),
            name == "box"
                ? "mesh.box { uvs = \"even\" } with little rounding has one scale on all sides"
                : "its UVs should be to one scale, and it no smaller than a tile");
    else
        warn_of_size(params, *cover.shape, tile);
}

constexpr double most_triangles = 5e7;

// Cells show their form with at least as many edges of triangles from side to side.
constexpr double edges_in_cell = 2.5;

/// Warns where so few triangles cannot show the leather's cells.
void warn_of_few_triangles(const Params& params, const CoverSettings& cover,
                           const ReliefRequest& request) {
    const double edge = request.settings.cell / edges_in_cell;
    constexpr auto most = static_cast<std::size_t>(most_triangles);
    std::size_t needed = 0;
    Vec3 centre;
    double radius = 0;
    if (cover.shape != nullptr && !covers_sphere(cover, centre, radius)) {
        needed = triangles_needed(*cover.shape, edge, most);
    } else {
        const double area =
            cover.shape != nullptr ? 4 * pi * radius * radius : request.size * request.size;
        needed = static_cast<std::size_t>(std::min(2 * area / (edge * edge), double(most) + 1));
    }
    if (needed <= cover.triangles)
        return;
    params.warn("triangles",
                fmt::format("{} are too few to show cells that are {:.3g} mm wide", cover.triangles,
                            1000 * request.settings.cell),
                needed <= most ? fmt::format("about {} would show them", needed)
                               : "a smaller shape, or a larger cell, needs fewer");
}

// How far a relief fades into that beyond a seam, in cells: less shows the seam as a step, more as
// a band where the relief is flat.
constexpr double blend_in_cells = 0.45;

/// Lifts the mesh to where the bare shape stood: a relief on its foot would sink into the ground.
void stand(Mesh& mesh, const Mesh& bare) {
    const float lift = bounds(bare).min.y - bounds(mesh).min.y;
    for (Vec3& p : mesh.positions)
        p.y += lift;
}

Mesh covered_shape(const CoverSettings& cover, const HeightField& field, double cell) {
    if (cover.shape == nullptr)
        return displaced_swatch(field, cover.thickness, cover.triangles);
    const Mesh& mesh = *cover.shape;
    Vec3 centre;
    double radius = 0;
    Mesh result = covers_sphere(cover, centre, radius)
                      ? displaced_sphere(field, centre, radius, cover.facing, cover.triangles)
                      : displaced_mesh(field, mesh, cover.triangles, blend_in_cells * cell);
    stand(result, mesh);
    result.name = mesh.name;
    return result;
}

WideMatrix world_from_shape(const CoverSettings& cover) {
    Matrix about_x, about_y, about_z;
    WideMatrix move;
    about_x.setAxisAngle(Vec3(1, 0, 0), cover.rotation.x);
    about_y.setAxisAngle(Vec3(0, 1, 0), cover.rotation.y);
    about_z.setAxisAngle(Vec3(0, 0, 1), cover.rotation.z);
    move.setTranslation(cover.position);
    return WideMatrix(about_x * about_y * about_z) * move;
}

Aggregate bake_leather(const ReliefRequest& request, const CoverSettings& cover,
                       const Context& context) {
    const auto start = std::chrono::steady_clock::now();
    ReliefFacts facts;
    const auto field =
        std::make_shared<const HeightField>(leather_relief(request, context, &facts));
    const auto mesh =
        std::make_shared<const Mesh>(covered_shape(cover, *field, request.settings.cell));

    Aggregate aggregate;
    aggregate.generator = "leather";
    aggregate.seed = request.seed;
    aggregate.prototypes.push_back(
        {.name = mesh->name, .shape = mesh, .materials = {cover.material}});
    Instance instance;
    instance.world_from_object = world_from_shape(cover);
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
                "size, or a sphere; one flat tile when not given. It stands as high as the bare "
                "shape.",
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
         .doc = "At most how many triangles the displaced shape has.",
         .fallback = std::int64_t{2000000},
         .min = 100.0,
         .max = most_triangles},
        material_spec("Its material"),
        {.name = "position",
         .type = ParamType::point3,
         .doc = "Where the shape's origin goes.",
         .unit = "m",
         .fallback = WideVec3(0)},
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

Plugin<Generator> leather_plugin() {
    return {
        "leather",
        "Leather: a relief of cristae and sulci that tiles seamlessly, as a height map and as a "
        "displaced shape (after Sakurai & Miyata 2014).",
        leather_specs(), [](const Params& params) -> Bake {
            const CoverSettings cover = cover_from(params);
            check(cover);
            const ReliefRequest request = request_from(params);
            warn_of_stretch(params, cover, request.size);
            warn_of_few_triangles(params, cover, request);
            return [request, cover](const Context& context) {
                return bake_leather(request, cover, context);
            };
        }};
}

} // namespace scree
