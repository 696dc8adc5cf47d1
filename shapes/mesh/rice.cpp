// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/component.h"
#include "shapes/mesh/sweep.h"

namespace scree {

namespace {

constexpr int grain_sides = 28;
constexpr int along = 44;

// A slightly flattened cross-section with the faint lengthwise ridges of a polished grain.
Ring section(double width, double height, double ridge) {
    Ring ring;
    for (int i = 0; i < grain_sides; ++i) {
        const double angle = 2 * pi * i / grain_sides;
        const double r = 1 + ridge * std::cos(6 * angle + 0.4);
        ring.emplace_back(width * r * std::cos(angle), height * r * std::sin(angle));
    }
    return ring;
}

Mesh rice(const Params& params) {
    const double length = params.number("length");
    const double width = number_or(params, "width", 0.3 * length);
    if (width > length)
        throw params.error("width", "must not be more than the length");
    const BentAxis axis(length, std::vector<double>(64, params.number("bend") / length));

    std::vector<SpaceRing> rings;
    for (int j = 0; j <= along; ++j) {
        const double s = -std::cos(pi * j / along); // rings are denser at the ends
        const double t = 0.5 + 0.5 * s;
        if (j == 0 || j == along) {
            rings.push_back(axis.place(Ring(grain_sides, Vec2(0.0)), t));
            continue;
        }
        // One end is blunter than the other and has the dent of the germ.
        const double taper = std::pow(1 - std::pow(std::abs(s), 2.4), s < 0 ? 0.5 : 0.56);
        const double r = taper * (1 + 0.05 * s) * width / 2;
        Ring ring = section(r, 0.82 * r, 0.018 * taper);
        const double dent = 0.07 * width * std::exp(-std::pow((s - 0.8) / 0.12, 2));
        for (Vec2& p : ring)
            if (p.x > 0)
                p.x -= dent * std::pow(p.x / r, 2);
        rings.push_back(axis.place(ring, t));
    }
    Mesh mesh = loft(rings);
    compute_normals(mesh, radians(60));
    return mesh;
}

} // namespace

Plugin<MakeMesh> rice_component() {
    return component("rice", "A grain of rice lying on its flatter side.",
                     {metres("length", "Length along the grain.", 0.0068),
                      optional_metres("width", "Greatest width; 0.3 of the length by default."),
                      angle_degrees("bend", "How far the grain turns from end to end.", 14, 0, 60)},
                     rice);
}

} // namespace scree
