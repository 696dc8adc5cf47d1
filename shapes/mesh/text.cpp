// SPDX-License-Identifier: GPL-3.0-or-later
// mesh.text: a word of block letters as one mesh, so that a solid texture runs through all of it.
#include "shapes/mesh/component.h"
#include "shapes/mesh/extrude.h"
#include "shapes/mesh/glyphs.h"

#include <algorithm>
#include <cctype>

namespace scree {

namespace {

constexpr double space_width = 3; // in the units of glyph_rings

struct Extent {
    double left;
    double right;
};

Extent extent_of(const std::vector<Ring>& rings) {
    Extent extent{rings.front().front().x, rings.front().front().x};
    for (const Vec2& p : rings.front()) {
        extent.left = std::min(extent.left, p.x);
        extent.right = std::max(extent.right, p.x);
    }
    return extent;
}

Mesh text(const Params& params) {
    const double unit = params.number("size") / glyph_height;
    const double gap = params.number("spacing") * glyph_height;
    const double height = number_or(params, "height", 1.6 * unit);
    const double bevel = params.number("bevel") * params.number("size");
    Mesh mesh;
    double pen = 0;
    for (const char character : params.text("text")) {
        if (character == ' ') {
            pen += space_width;
            continue;
        }
        std::vector<Ring> rings =
            glyph_rings(char(std::toupper(static_cast<unsigned char>(character))));
        if (rings.empty())
            throw params.error("text", "\"" + params.text("text") +
                                           "\" has characters other than A to Z, 0 to 9, . and -");
        const Extent extent = extent_of(rings);
        for (Ring& ring : rings)
            for (Vec2& p : ring)
                p = (p + Vec2(pen - extent.left, 0.0)) * unit;
        append(mesh, extrude(rings, height, bevel));
        pen += extent.right - extent.left + gap;
    }
    if (mesh.triangles.empty())
        throw params.error("text", "has no letters");
    if (params.text("pose") == "standing") {
        Matrix turn;
        turn.setAxisAngle(Vec3(1, 0, 0), static_cast<float>(pi / 2));
        transform(mesh, turn);
    }
    return mesh;
}

} // namespace

Plugin<MakeMesh> text_component() {
    return component(
        "text", "A word of block letters as one body, as if cut from one block.",
        {{.name = "text",
          .type = ParamType::text,
          .doc = "Consists of A to Z, 0 to 9, ., - and spaces.",
          .fallback = std::string("SCREE")},
         metres("size", "Height of a capital.", 0.06),
         optional_metres("height", "Thickness; 0.23 of the size by default."),
         ratio("spacing", "Gap between letters as a share of the size.", 0.13, 0.01, 10),
         ratio("bevel", "Radius of the edges as a share of the size; 0: sharp.", 0.024, 0, 0.1),
         {.name = "pose",
          .type = ParamType::choice,
          .doc = "Upright facing +z, or on its back, readable from above.",
          .fallback = std::string("standing"),
          .choices = {"standing", "lying"}}},
        text);
}

} // namespace scree
