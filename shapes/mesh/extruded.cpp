// SPDX-License-Identifier: GPL-3.0-or-later
// mesh.extrude: any region as a solid.
#include "geometry/plane/region_tools.h"
#include "shapes/mesh/component.h"
#include "shapes/mesh/extrude.h"
#include "shapes/mesh/outline.h"

#include <algorithm>

namespace scree {

namespace {

Region disk() { return triangulate({circle(0.03, 48)}); }

Mesh extruded(const Params& params) {
    const Region region = params.has("outline") ? *params.object<Region>("outline") : disk();
    if (!(area(region) > 0))
        throw params.error("outline", "the region has no area");
    // `extrude` takes points (x, -z), so the rings are mirrored, and reversed to stay oriented.
    std::vector<Ring> rings = region.rings;
    for (Ring& ring : rings) {
        for (Vec2& p : ring)
            p.y = -p.y;
        std::reverse(ring.begin(), ring.end());
    }
    const double height = params.number("height");
    Mesh mesh = extrude(rings, height, params.number("rounding"), 12);
    if (params.flag("upright")) // a rotation about x: -z becomes y, y becomes z
        transform(mesh, Matrix(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1));
    return mesh;
}

} // namespace

Plugin<MakeMesh> extrude_component() {
    ParamSpec outline{.name = "outline",
                      .type = ParamType::object,
                      .families = {"region"},
                      .doc = "Its outline; a disk when not given.",
                      .optional = true};
    return component(
        "extrude", "A region given a height: a slab with its outline and rounded edges.",
        {std::move(outline),
         metres("height", "Height.", 0.02),
         {.name = "rounding",
          .type = ParamType::number,
          .doc = "Radius of the edges; reduced to what the outline and the height allow.",
          .unit = "m",
          .fallback = 0.0,
          .min = 0,
          .max = 100},
         {.name = "upright",
          .type = ParamType::boolean,
          .doc = "Stands it up, the far side of its outline on top; otherwise it lies flat.",
          .fallback = false}},
        extruded);
}

} // namespace scree
