// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/component.h"
#include "shapes/mesh/extrude.h"
#include "shapes/mesh/glyphs.h"

#include <cctype>

namespace scree {

namespace {

Mesh letter(const Params& params) {
    const std::string& text = params.text("letter");
    std::vector<Ring> rings;
    if (text.size() == 1)
        rings = glyph_rings(char(std::toupper(static_cast<unsigned char>(text.front()))));
    if (rings.empty())
        throw params.error("letter", "\"" + text + "\" is not one of A to Z, 0 to 9, . and -");
    const double unit = params.number("size") / glyph_height;
    for (Ring& ring : rings)
        for (Vec2& p : ring)
            p *= unit;
    const double height = number_or(params, "height", 1.6 * unit);
    return extrude(rings, height, 0.17 * unit);
}

} // namespace

Plugin<MakeMesh> letter_component() {
    return component("letter", "A block letter or digit lying on its back, readable from above.",
                     {{.name = "letter",
                       .type = ParamType::text,
                       .doc = "One of A to Z, 0 to 9, . or -.",
                       .fallback = std::string("A")},
                      metres("size", "Height of a capital.", 0.06),
                      optional_metres("height", "Thickness; 0.23 of the size by default.")},
                     letter);
}

} // namespace scree
