// SPDX-License-Identifier: GPL-3.0-or-later
// Flat toys with rounded edges: mesh.l_brick, star, heart and crescent.
#include "shapes/mesh/component.h"
#include "shapes/mesh/extrude.h"
#include "shapes/mesh/outline.h"

#include <algorithm>

namespace scree {

namespace {

Mesh l_brick(const Params& params) {
    const double length = params.number("length");
    const double depth = number_or(params, "depth", 0.7 * length);
    const double arm = number_or(params, "arm", 0.36 * length);
    const double height = number_or(params, "height", 0.33 * length);
    if (arm >= std::min(length, depth))
        throw params.error("arm", "must be less than length and depth");
    const double corner = params.number("rounding") * std::min(arm, height);
    const std::vector<Corner> outline{{0, 0, corner},        {length, 0, corner},
                                      {length, arm, corner}, {arm, arm, 0.5 * corner},
                                      {arm, depth, corner},  {0, depth, corner}};
    return extrude({round_corners(outline, 6)}, height, 0.75 * corner);
}

Mesh star(const Params& params) {
    const int points = int(params.integer("points"));
    const double radius = params.number("radius");
    const double inner = params.number("inner") * radius;
    const double height = number_or(params, "height", 0.36 * radius);
    std::vector<Corner> outline;
    for (int k = 0; k < 2 * points; ++k) {
        const bool tip = k % 2 == 0;
        const Vec2 p = rotate({tip ? radius : inner, 0.0}, pi / 2 + pi * k / points);
        outline.push_back({p.x, p.y, (tip ? 0.08 : 0.05) * radius});
    }
    return extrude({round_corners(outline, 12)}, height, 0.3 * height);
}

Mesh heart(const Params& params) {
    const double width = params.number("width");
    const double height = number_or(params, "height", 0.28 * width);
    // Two circular lobes of radius 1 and their tangents through the tip.
    const Vec2 lobe(0.9, 0.0);
    const Vec2 tip(0.0, -2.2);
    const Vec2 to_tip = tip - lobe;
    const double low = std::atan2(to_tip.y, to_tip.x) + std::acos(1 / to_tip.length());
    const double notch = pi - std::acos(lobe.x);
    std::vector<Corner> outline{{tip.x, tip.y, 0.22}};
    const Ring right = arc(lobe, 1, low, notch, 40);
    for (const Vec2& p : right)
        outline.push_back({p.x, p.y, 0});
    for (std::size_t i = right.size() - 1; i-- > 0;)
        outline.push_back({-right[i].x, right[i].y, 0});
    const double scale = width / (2 * (1 + lobe.x));
    for (Corner& c : outline)
        c = {c.x * scale, c.y * scale, c.radius * scale};
    return extrude({round_corners(outline, 10)}, height, 0.42 * height);
}

Mesh crescent(const Params& params) {
    const double radius = params.number("radius");
    const double height = number_or(params, "height", 0.36 * radius);
    // The unit disk minus a smaller disk, whose centre lies `shift` to the right and which leaves
    // a width of `waist` on the left.
    const double waist = params.number("waist");
    const double inner = 0.8;
    const double shift = inner - 1 + waist;
    // The horns end in circles of radius `blunt` that are tangent to both: their centres lie
    // 1 - blunt from one centre and inner + blunt from the other.
    const double blunt = 0.07;
    const double far = 1 - blunt;
    const double near = inner + blunt;
    const double x = (far * far - near * near + shift * shift) / (2 * shift);
    const Vec2 horn(x, std::sqrt(far * far - x * x));
    const double outer_angle = std::atan2(horn.y, horn.x);
    const double inner_angle = std::atan2(horn.y, horn.x - shift);
    Ring outline = arc({0, 0}, 1, outer_angle, 2 * pi - outer_angle, 72);
    const auto add = [&](const Ring& ring) { // its first point is the outline's last
        outline.insert(outline.end(), ring.begin() + 1, ring.end());
    };
    add(arc({horn.x, -horn.y}, blunt, -outer_angle, pi - inner_angle, 14));
    add(arc({shift, 0.0}, inner, 2 * pi - inner_angle, inner_angle, 56));
    add(arc(horn, blunt, inner_angle - pi, outer_angle, 14));
    outline.pop_back();
    for (Vec2& p : outline)
        p *= radius;
    return extrude({outline}, height, 0.3 * height);
}

} // namespace

Plugin<MakeMesh> l_brick_component() {
    return component(
        "l_brick", "An L-shaped toy brick with soft edges, lying flat.",
        {metres("length", "Side along x.", 0.06),
         optional_metres("depth", "Side along z; 0.7 of the length by default."),
         optional_metres("arm", "Width of both arms; 0.36 of the length by default."),
         optional_metres("height", "Height; 0.33 of the length by default."),
         ratio("rounding", "Radius of corners as a share of the narrowest side.", 0.12, 0, 0.4)},
        l_brick);
}

Plugin<MakeMesh> star_component() {
    return component(
        "star", "A star with rounded points, lying flat.",
        {metres("radius", "From the middle to the points.", 0.035),
         count("points", "Number of points.", 5, 3, 24),
         ratio("inner", "Radius of the inner corners as a share of the outer.", 0.48, 0.2, 0.9),
         optional_metres("height", "Height; 0.36 of the radius by default.")},
        star);
}

Plugin<MakeMesh> heart_component() {
    return component("heart", "A plump heart, lying flat.",
                     {metres("width", "Width across both lobes.", 0.06),
                      optional_metres("height", "Height; 0.28 of the width by default.")},
                     heart);
}

Plugin<MakeMesh> crescent_component() {
    return component(
        "crescent", "A crescent moon with blunt horns, lying flat.",
        {metres("radius", "Radius of the outer circle.", 0.035),
         ratio("waist", "Width in the middle as a share of the radius.", 0.62, 0.3, 1.1),
         optional_metres("height", "Height; 0.36 of the radius by default.")},
        crescent);
}

} // namespace scree
