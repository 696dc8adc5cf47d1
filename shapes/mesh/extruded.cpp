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
    // Its far side (-z) is up in the plane that extrude works in, so rings turn round with it.
    std::vector<Ring> rings = region.rings;
    for (Ring& ring : rings) {
        for (Vec2& p : ring)
            p.y = -p.y;
        std::reverse(ring.begin(), ring.end());
    }
    const double height = params.number("height");
    Mesh mesh = extrude(rings, height, params.number("rounding"), 12);
    if (params.flag("upright")) // x stays, the far side goes up, the upper face to the front
        transform(mesh, Matrix(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1));
    return mesh;
}

} // namespace

Plugin<MakeMesh> extrude_component() {
    ParamSpec outline{.name = "outline",
                      .type = ParamType::object,
                      .families = {"region"},
                      .doc = "Its plan; a disk unless given.",
                      .optional = true};
    return component("extrude",
                     "A region given a height: a slab with its outline and rounded edges.",
                     {std::move(outline),
                      metres("height", "Height.", 0.02),
                      {.name = "rounding",
                       .type = ParamType::number,
                       .doc = "Radius of the edges; less where outline or height do not allow it.",
                       .unit = "m",
                       .fallback = 0.0,
                       .min = 0,
                       .max = 100},
                      {.name = "upright",
                       .type = ParamType::boolean,
                       .doc = "It stands, the outline's far side up, in place of lying.",
                       .fallback = false}},
                     extruded);
}

} // namespace scree
