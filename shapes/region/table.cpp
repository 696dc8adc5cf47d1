// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/table.h"

#include "core/located.h"
#include "geometry/plane/region_shapes.h"
#include "geometry/plane/region_tools.h"
#include "shapes/region/image_region.h"
#include "shapes/region/svg_regions.h"

#include <fmt/format.h>

namespace scree {

namespace {

ParamSpec length(std::string name, std::string doc, double fallback) {
    return number_spec(std::move(name), std::move(doc), "m", fallback, 1e-6, 1e6);
}

void check_stroke(const Params& params, double limit) {
    if (params.number("stroke") >= limit)
        throw params.error("stroke",
                           fmt::format("{} m is too wide for a size of {} m: it must be "
                                       "less than {} m",
                                       params.number("stroke"), params.number("size"), limit));
}

Plugin<MakeRegion> rectangle_plugin() {
    return {"rectangle",
            "A rectangle about the origin.",
            {length("width", "Length along x.", 1.0), length("depth", "Length along z.", 1.0)},
            [](const Params& params) {
                return triangulate(
                    {rectangle_ring(params.number("width"), params.number("depth"))});
            }};
}

Plugin<MakeRegion> circle_plugin() {
    return {"circle",
            "A regular polygon about the origin, its corners on a circle.",
            {length("radius", "Radius of the circle.", 0.5),
             {.name = "segments",
              .type = ParamType::integer,
              .doc = "Number of corners.",
              .fallback = std::int64_t{64},
              .min = 3,
              .max = 10000}},
            [](const Params& params) {
                return triangulate({circle_ring(params.number("radius"),
                                                static_cast<int>(params.integer("segments")))});
            }};
}

Plugin<MakeRegion> star_plugin() {
    return {"star",
            "A star about the origin.",
            {length("radius", "Distance of the tips from the centre.", 0.5),
             {.name = "inner",
              .type = ParamType::number,
              .doc = "Distance of the inner corners as a share of the radius.",
              .fallback = 0.4,
              .min = 0.01,
              .max = 0.99},
             {.name = "points",
              .type = ParamType::integer,
              .doc = "Number of tips.",
              .fallback = std::int64_t{5},
              .min = 2,
              .max = 1000}},
            [](const Params& params) {
                return triangulate({star_ring(params.number("radius"), params.number("inner"),
                                              static_cast<int>(params.integer("points")))});
            }};
}

Plugin<MakeRegion> letter_plugin(std::string name, std::string doc, Ring (*outline)(double, double),
                                 double widest) {
    return {std::move(name),
            std::move(doc),
            {length("size", "Longest side.", 1.0), length("stroke", "Width of a stroke.", 0.3)},
            [outline, widest](const Params& params) {
                check_stroke(params, widest * params.number("size"));
                return triangulate({outline(params.number("size"), params.number("stroke"))});
            }};
}

Region polygon(const Params& params) {
    const Ring& outer = params.points("points");
    std::vector<Ring> rings{outer};
    // Each ring is checked alone first, so that an error is located at that ring.
    const Region whole = located(params, "points", [&] { return triangulate({outer}); });
    const std::vector<Params> none;
    const std::vector<Params>& holes = params.has("holes") ? params.list("holes") : none;
    for (const Params& hole : holes) {
        const Ring& ring = hole.points("points");
        located(hole, "points", [&] { return triangulate({ring}); });
        if (!contains(whole, ring.front()))
            throw hole.error("points", fmt::format("the hole at ({}, {}) lies outside the polygon",
                                                   ring.front().x, ring.front().y));
        rings.push_back(ring);
    }
    Region region = located(params, "holes", [&] { return triangulate(rings); });
    double expected = area(whole);
    for (std::size_t i = 1; i < rings.size(); ++i)
        expected -= std::abs(signed_area(rings[i]));
    if (std::abs(area(region) - expected) > 1e-9 * area(whole))
        throw params.error("holes", "a hole lies inside another hole");
    return region;
}

Plugin<MakeRegion> polygon_plugin() {
    const auto points = [](std::string doc) {
        return ParamSpec{.name = "points",
                         .type = ParamType::points,
                         .doc = std::move(doc),
                         .unit = "m",
                         .min_items = 3};
    };
    return {"polygon",
            "A polygon with holes in the x-z plane; rings may wind either way.",
            {points("Corners of the outline; no two edges may cross or touch."),
             {.name = "holes",
              .type = ParamType::list,
              .doc = "Holes, each a table with `points`.",
              .optional = true,
              .fields = {points("Corners of the hole.")}}},
            polygon};
}

Plugin<MakeRegion> mesh_silhouette_plugin() {
    return {
        "mesh_silhouette",
        "The silhouette of a mesh from above, with holes; it always covers the mesh.",
        {{.name = "mesh", .type = ParamType::object, .families = {"mesh"}, .doc = "The mesh."},
         {.name = "tolerance",
          .type = ParamType::number,
          .doc =
              "Maximum distance of the outline outside the mesh, as a share of its longest side.",
          .fallback = 0.005,
          .min = 0.0,
          .max = 0.2}},
        [](const Params& params) {
            return located(params, "mesh", [&] {
                return silhouette(*params.object<Mesh>("mesh"),
                                  {.tolerance = params.number("tolerance")});
            });
        }};
}

} // namespace

Registry<MakeRegion> region_table() {
    Registry<MakeRegion> table("region");
    table.add(rectangle_plugin());
    table.add(polygon_plugin());
    table.add(circle_plugin());
    table.add(star_plugin());
    table.add(letter_plugin("l", "The letter L.", l_ring, 1.0));
    table.add(letter_plugin("u", "The letter U.", u_ring, 0.5));
    table.add(letter_plugin("chevron", "A V, open towards +z.", chevron_ring, 1e6));
    table.add(mesh_silhouette_plugin());
    table.add(image_region_plugin());
    table.add(svg_region_plugin());
    table.add(path_region_plugin());
    return table;
}

} // namespace scree
