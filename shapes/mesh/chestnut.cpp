// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/component.h"
#include "shapes/mesh/loft.h"

#include <algorithm>

namespace scree {

namespace {

constexpr int chestnut_sides = 48;
constexpr int steps = 3;

// (half width, height) of the outline from the pale base, whose rim is a shallow step, to the tip.
constexpr double outline[][2] = {{0.00, -0.74},  {0.28, -0.755}, {0.50, -0.745}, {0.63, -0.715},
                                 {0.665, -0.70}, {0.70, -0.685}, {0.80, -0.60},  {0.92, -0.38},
                                 {0.99, -0.10},  {0.995, 0.12},  {0.92, 0.37},   {0.77, 0.58},
                                 {0.57, 0.74},   {0.36, 0.85},   {0.20, 0.915},  {0.11, 0.965},
                                 {0.072, 1.02},  {0.06, 1.07},   {0.035, 1.095}, {0.0, 1.10}};

Ring smooth_outline() {
    constexpr int count = int(std::size(outline));
    const auto point = [](int i) {
        const double side = i < 0 || i >= count ? -1 : 1; // mirrored at both poles
        i = i < 0 ? -i : (i >= count ? 2 * count - 2 - i : i);
        return Vec2(side * outline[i][0], outline[i][1]);
    };
    Ring ring;
    for (int i = 0; i + 1 < count; ++i) {
        const Vec2 a = point(i - 1);
        const Vec2 b = point(i);
        const Vec2 c = point(i + 1);
        const Vec2 d = point(i + 2);
        for (int k = 0; k < steps; ++k) { // Catmull-Rom
            const double t = double(k) / steps;
            ring.push_back((b * 2.0 + (c - a) * t + (a * 2.0 - b * 5.0 + c * 4.0 - d) * (t * t) +
                            (b * 3.0 - a - c * 3.0 + d) * (t * t * t)) *
                           0.5);
        }
    }
    ring.emplace_back(0, outline[count - 1][1]);
    return ring;
}

Mesh chestnut(const Params& params) {
    const double half_width = params.number("width") / 2;
    const double thickness = params.number("thickness");
    // Chestnuts grow in pairs: one cheek is flat, the other round.
    const double full = 1.3 * thickness;
    const double flat = 0.7 * thickness;
    std::vector<SpaceRing> rings;
    for (const Vec2& p : smooth_outline()) {
        SpaceRing ring;
        for (int i = 0; i < chestnut_sides; ++i) {
            const double angle = 2 * pi * i / chestnut_sides;
            const double c = std::cos(angle);
            const double s = std::sin(angle);
            const double cheek = s < 0 ? full * -s : -flat * std::pow(s, 0.62);
            // The tip lies between the cheeks, closer to the flat one.
            const double round = std::clamp((p.y - 0.85) / 0.2, 0.0, 1.0);
            const double depth = cheek * (1 - round) + -s * round;
            const Imath::V3d at(p.x * c, p.y * 0.86, p.x * depth);
            // Rotated onto the flat cheek: z becomes y.
            ring.emplace_back(Imath::V3d(at.x, at.z, -at.y) * half_width);
        }
        if (p.x <= 0)
            ring = pole(chestnut_sides, Vec3(Imath::V3d(0, 0, -0.86 * p.y) * half_width));
        rings.push_back(std::move(ring));
    }
    Mesh mesh = loft(rings);
    compute_normals(mesh, radians(60));
    return mesh;
}

} // namespace

Plugin<MakeMesh> chestnut_component() {
    return component("chestnut", "A sweet chestnut lying on its flat cheek.",
                     {metres("width", "Greatest width.", 0.03),
                      ratio("thickness", "Thickness as a share of the width.", 0.62, 0.3, 1)},
                     chestnut);
}

} // namespace scree
