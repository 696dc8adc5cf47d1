// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/component.h"
#include "shapes/mesh/extrude.h"
#include "shapes/mesh/outline.h"

#include <algorithm>

namespace scree {

namespace {

constexpr double pressure_angle = radians(20);

double involute(double angle) { return std::tan(angle) - angle; }

// One tooth about the +x axis, counter-clockwise from the root on its near side to the root on its
// far side: involute flanks with ISO 53 proportions (addendum 1, dedendum 1.25 modules).
std::vector<Corner> tooth(int teeth, double tip_radius) {
    const double module = 2 * tip_radius / (teeth + 2);
    const double pitch_radius = module * teeth / 2;
    const double base = pitch_radius * std::cos(pressure_angle);
    const double root = pitch_radius - 1.25 * module;
    // Half of the tooth's angle at radius r. The tooth is slightly thinner than half the pitch, for
    // backlash.
    const auto half_angle = [&](double r) {
        const double at = std::acos(std::min(1.0, base / r));
        return pi / (2 * teeth) * 0.97 + involute(pressure_angle) - involute(at);
    };
    const double from = std::max(base, root + 0.1 * module);
    constexpr int steps = 4;
    std::vector<Corner> right;
    const auto add = [&](double r, double angle, double rounding) {
        const Vec2 p = rotate({r, 0.0}, -angle);
        right.push_back({p.x, p.y, rounding * module});
    };
    add(root, half_angle(from), 0.28);
    for (int i = 0; i <= steps; ++i) {
        const double r = from + (tip_radius - from) * i / steps;
        add(r, half_angle(r), i == steps ? 0.2 : 0);
    }
    std::vector<Corner> out = right;
    for (std::size_t i = right.size(); i-- > 0;)
        out.push_back({right[i].x, -right[i].y, right[i].radius});
    return out;
}

Mesh gear(const Params& params) {
    const int teeth = int(params.integer("teeth"));
    const double tip = params.number("radius");
    const double root = tip * (1 - 4.5 / (teeth + 2));
    const double bore = number_or(params, "bore", 0.2 * tip);
    if (bore > 0.8 * root)
        throw params.error("bore", "leaves no body under the teeth");
    std::vector<Corner> outline;
    const std::vector<Corner> one = tooth(teeth, tip);
    for (int k = 0; k < teeth; ++k)
        for (const Corner& c : one) {
            const Vec2 p = rotate({c.x, c.y}, 2 * pi * k / teeth);
            outline.push_back({p.x, p.y, c.radius});
        }
    std::vector<Ring> rings{round_corners(outline, 3)};
    const auto add_hole = [&](double radius, int segments, const Vec2& center) {
        Ring ring = circle(radius, segments, center);
        std::reverse(ring.begin(), ring.end());
        rings.push_back(std::move(ring));
    };
    add_hole(bore, 48, Vec2(0.0));
    // Lightening holes half-way between bore and root.
    const int holes = int(params.integer("holes"));
    const double middle = (bore + root) / 2;
    const double room = std::min((root - bore) / 2, holes > 0 ? middle * std::sin(pi / holes) : 0);
    for (int k = 0; k < holes; ++k)
        add_hole(0.6 * room, 32, rotate({middle, 0.0}, 2 * pi * k / holes));
    const double height = number_or(params, "height", 0.3 * tip);
    return extrude(rings, height, 0.36 * tip / (teeth + 2), 3);
}

} // namespace

Plugin<MakeMesh> gear_component() {
    return component("gear", "A spur gear with involute teeth, lying flat.",
                     {metres("radius", "Radius over the teeth.", 0.02),
                      count("teeth", "Number of teeth.", 18, 8, 200),
                      optional_metres("height", "Height; 0.3 of the radius by default."),
                      optional_metres("bore", "Radius of the bore; 0.2 of the radius by default."),
                      count("holes", "Lightening holes round the bore.", 5, 0, 12)},
                     gear);
}

} // namespace scree
