// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of revolution: mesh.sphere, torus, cylinder, cone, ring and pin.
#include "shapes/mesh/component.h"
#include "shapes/mesh/loft.h"
#include "shapes/mesh/outline.h"

#include <algorithm>

namespace scree {

namespace {

constexpr double round_crease = radians(30);

Mesh smooth(Mesh mesh) {
    compute_normals(mesh, round_crease);
    return mesh;
}

// For rounded solids with flat parts, which must be shaded flat.
Mesh bevelled(Mesh mesh) {
    compute_normals(mesh, round_crease, NormalWeight::angle_and_area);
    return mesh;
}

int segments_of(const Params& params) { return int(params.integer("segments")); }

ParamSpec segments_spec() {
    return count("segments", "Segments around the axis of revolution.", 64, 12, 512);
}

// Closes a profile by repeating its first point.
Ring closed(Ring ring) {
    ring.push_back(Vec2(ring.front()));
    return ring;
}

Mesh sphere(const Params& params) {
    const double radius = params.number("radius");
    const int segments = segments_of(params);
    Ring profile = arc({0, 0}, radius, -pi / 2, pi / 2, segments / 2);
    profile.front() = {0, -radius};
    profile.back() = {0, radius};
    Mesh mesh = revolve(profile, segments);
    for (const Vec3& p : mesh.positions)
        mesh.normals.push_back(p.normalized());
    return mesh;
}

Mesh torus(const Params& params) {
    const double radius = params.number("radius");
    const double tube = number_or(params, "tube", 0.35 * radius);
    if (tube >= radius)
        throw params.error("tube", "must be less than the radius");
    const int segments = segments_of(params);
    return smooth(
        revolve(closed(circle(tube, std::max(8, segments / 2), {radius, 0.0})), segments));
}

Mesh cylinder(const Params& params) {
    const double radius = params.number("radius");
    const double height = params.number("height");
    const double edge = params.number("rounding") * std::min(radius, height / 2);
    return bevelled(
        revolve(round_curve({{0, 0}, {radius, 0, edge}, {radius, height, edge}, {0, height}}, 6),
                segments_of(params)));
}

Mesh cone(const Params& params) {
    const double radius = params.number("radius");
    const double top = params.number("top") * radius;
    const double height = params.number("height");
    const double edge = params.number("rounding") * std::min(radius, height) / 2;
    // The whole symmetric outline is rounded, then its left half is removed.
    std::vector<Corner> corners{{0, 0}, {radius, 0, edge}, {top, height, edge}};
    if (top > 0)
        corners.push_back({-top, height, edge});
    corners.push_back({-radius, 0});
    Ring profile;
    for (const Vec2& p : round_curve(corners, 8)) {
        if (profile.size() > 1 && p.x <= 1e-6 * radius) {
            const Vec2& last = profile.back();
            profile.emplace_back(0.0, last.y + (p.y - last.y) * last.x / (last.x - p.x));
            break;
        }
        profile.push_back(p);
    }
    return bevelled(revolve(profile, segments_of(params)));
}

Mesh ring(const Params& params) {
    const double radius = params.number("radius");
    const double hole = number_or(params, "hole", 0.42 * radius);
    const double height = number_or(params, "height", 0.5 * radius);
    if (hole >= radius)
        throw params.error("hole", "must be less than the radius");
    // Stacking rings are rounder outside than inside.
    const double outer = 0.5 * std::min(height, radius - hole);
    const double inner = 0.45 * outer;
    return smooth(revolve(
        closed(round_corners(
            {{radius, 0, outer}, {radius, height, outer}, {hole, height, inner}, {hole, 0, inner}},
            12)),
        segments_of(params)));
}

// Height and radius of a ten-pin bowling pin as shares of its height, after the USBC specification
// (15 inches high, 4.766 inches across the belly); the top is a half sphere.
constexpr double pin_outline[][2] = {
    {0.0660, 0.000},  {0.0943, 0.050},  {0.1302, 0.150}, {0.1503, 0.225},  {0.1589, 0.300},
    {0.1521, 0.392},  {0.1234, 0.483},  {0.0824, 0.575}, {0.0655, 0.625},  {0.0599, 0.667},
    {0.0623, 0.725},  {0.0698, 0.783},  {0.0790, 0.842}, {0.0849, 0.9151}, {0.0784, 0.9476},
    {0.0600, 0.9751}, {0.0325, 0.9935}, {0.0, 1.0}};

// Catmull-Rom through the outline.
Ring pin_profile(double height, double width) {
    const int count = int(std::size(pin_outline));
    const auto point = [&](int i) {
        const double mirror = i >= count ? -1 : 1; // smooth over the top
        i = std::clamp(i >= count ? 2 * count - 2 - i : i, 0, count - 1);
        return Vec2(mirror * pin_outline[i][0] * width, pin_outline[i][1]) * height;
    };
    Ring profile{{0, 0}, {0.9 * point(0).x, 0}, {0.975 * point(0).x, 0.004 * height}};
    constexpr int steps = 3;
    for (int i = 0; i + 1 < count; ++i) {
        const Vec2 a = i == 0 ? point(0) * 2.0 - point(1) : point(i - 1);
        const Vec2 b = point(i);
        const Vec2 c = point(i + 1);
        const Vec2 d = point(i + 2);
        for (int k = i == 0 ? 1 : 0; k < steps; ++k) {
            const double t = double(k) / steps;
            profile.push_back((b * 2.0 + (c - a) * t + (a * 2.0 - b * 5.0 + c * 4.0 - d) * (t * t) +
                               (b * 3.0 - a - c * 3.0 + d) * (t * t * t)) *
                              0.5);
        }
    }
    profile.emplace_back(0.0, height);
    return profile;
}

Mesh pin(const Params& params) {
    const double height = params.number("height");
    Mesh mesh = smooth(revolve(pin_profile(height, params.number("belly")), segments_of(params)));
    if (params.text("pose") == "lying") { // resting on its belly and head
        Matrix turn;
        turn.setEulerAngles(
            Vec3(0, 0,
                 static_cast<float>(
                     pi / 2 + std::atan2((0.1589 - 0.0849) * params.number("belly"), 0.615))));
        transform(mesh, turn);
    }
    return mesh;
}

} // namespace

Plugin<MakeMesh> sphere_component() {
    return component("sphere", "A ball.",
                     {metres("radius", "Radius of the ball.", 0.035), segments_spec()}, sphere);
}

Plugin<MakeMesh> torus_component() {
    return component("torus", "A ring of round section, lying flat.",
                     {metres("radius", "From the axis to the middle of the tube.", 0.04),
                      optional_metres("tube", "Radius of the tube; 0.35 of the radius by default."),
                      segments_spec()},
                     torus);
}

Plugin<MakeMesh> cylinder_component() {
    return component(
        "cylinder", "An upright cylinder with rounded edges.",
        {metres("radius", "Radius.", 0.03), metres("height", "Height.", 0.06),
         ratio("rounding", "Radius of the edges as a share of what fits; 0: sharp.", 0.08, 0, 0.95),
         segments_spec()},
        cylinder);
}

Plugin<MakeMesh> cone_component() {
    return component(
        "cone", "An upright cone with a rounded tip and foot.",
        {metres("radius", "Radius of the foot.", 0.03), metres("height", "Height.", 0.07),
         ratio("top", "Radius of the top as a share of that of the foot.", 0, 0, 1),
         ratio("rounding", "Radius of the edges as a share of what fits; 0: sharp.", 0.15, 0, 0.95),
         segments_spec()},
        cone);
}

Plugin<MakeMesh> ring_component() {
    return component("ring", "A fat stacking ring, lying flat.",
                     {metres("radius", "Outer radius.", 0.045),
                      optional_metres("hole", "Radius of the hole; 0.42 of the outer by default."),
                      optional_metres("height", "Height; half of the radius by default."),
                      segments_spec()},
                     ring);
}

Plugin<MakeMesh> pin_component() {
    return component("pin", "A toy bowling pin.",
                     {metres("height", "Height of the pin.", 0.16),
                      ratio("belly", "Width as a multiple of a ten-pin's.", 1.15, 0.5, 2),
                      {.name = "pose",
                       .type = ParamType::choice,
                       .doc = "Whether it stands or lies.",
                       .fallback = std::string("standing"),
                       .choices = {"standing", "lying"}},
                      segments_spec()},
                     pin);
}

} // namespace scree
