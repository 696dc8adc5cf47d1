// SPDX-License-Identifier: GPL-3.0-or-later
// mesh.bolt and mesh.nut, after ISO 4014 and ISO 4032.
#include "shapes/mesh/component.h"
#include "shapes/mesh/hexagon.h"
#include "shapes/mesh/thread.h"

#include <algorithm>

namespace scree {

namespace {

constexpr double fastener_crease = radians(25);
constexpr double max_turns = 200;

// Limits the mesh's size: a turn of the thread has about 500 triangles.
void check_turns(const Params& params, double length, double pitch, double diameter) {
    if (pitch > diameter / 2)
        throw params.error("pitch", "must be at most half of the diameter");
    if (length > max_turns * pitch)
        throw params.error("pitch", "the thread would have more than 200 turns");
}

// The slope of a 30 degree chamfer, reduced where the upper and the lower one would meet on the
// corners of a thin part.
double chamfer_slope(double across, double circle, double height) {
    return std::min(std::tan(pi / 6), 0.4 * height / (across / std::sqrt(3.0) - circle));
}

Mesh finished(Mesh mesh) {
    compute_normals(mesh, fastener_crease, NormalWeight::angle_and_area);
    return mesh;
}

Mesh bolt(const Params& params) {
    const double diameter = params.number("diameter");
    const double length = params.number("length");
    const double pitch = number_or(params, "pitch", coarse_pitch(diameter));
    const double across = number_or(params, "head_width", 1.6 * diameter);
    const double head = number_or(params, "head_height", 0.65 * diameter);
    if (across < 1.2 * diameter)
        throw params.error("head_width", "must be at least 1.2 times the diameter");
    if (head > 20 * diameter)
        throw params.error("head_height", "must be at most 20 times the diameter");
    const double top =
        std::clamp(number_or(params, "thread", 2.75 * diameter), 0.3 * length, 0.97 * length);

    const double crest = diameter / 2;
    const double root = crest - thread_depth(pitch);
    const double chamfer = std::min(0.8 * (crest - root), 0.2 * length);
    const double bottom = chamfer;
    check_turns(params, top - bottom, pitch, diameter);

    const Hexagon hexagon(across);
    const auto level = [&](double radius, double y) {
        return level_ring(hexagon.angles, radius, y);
    };
    const std::size_t n = hexagon.angles.size();
    Mesh mesh = loft({pole(n, Vec3(0.0F)), level(root - chamfer, 0), level(root, bottom)});
    append(mesh, thread_surface(hexagon.angles, {.pitch = pitch,
                                                 .root_radius = root,
                                                 .crest_radius = crest,
                                                 .end_radius = root,
                                                 .bottom = bottom,
                                                 .top = top,
                                                 .fade = std::min(pitch, 0.2 * (top - bottom))}));
    const double rise = std::min(crest - root, 0.5 * (length - top));
    const double y = length + head;
    const double circle = 0.475 * across;
    append(mesh, loft({level(root, top), level(crest, top + rise), level(crest, length),
                       hexagon.chamfered(length, 0.5 * across, 0),
                       hexagon.chamfered(y, circle, chamfer_slope(across, circle, head)),
                       level(circle, y), pole(n, Vec3(0, static_cast<float>(y), 0))}));
    if (params.text("pose") == "lying") {
        // Resting on a flat of the head, which faces +x, and on the end of the thread.
        const double tilt = std::atan2(across / 2 - crest, length);
        Matrix turn;
        turn.setEulerAngles(Vec3(0, 0, static_cast<float>(-pi / 2 - tilt)));
        transform(mesh, turn);
    } else { // standing on its head
        Matrix turn;
        turn.setEulerAngles(Vec3(static_cast<float>(pi), 0, 0));
        transform(mesh, turn);
    }
    return finished(std::move(mesh));
}

Mesh nut(const Params& params) {
    const double diameter = params.number("diameter");
    const double pitch = number_or(params, "pitch", coarse_pitch(diameter));
    const double across = number_or(params, "width", 1.6 * diameter);
    const double height = number_or(params, "height", 0.84 * diameter);
    if (across < 1.2 * diameter)
        throw params.error("width", "must be at least 1.2 times the diameter");
    const double mouth = 0.5 * 1.04 * diameter; // countersunk
    const double wall = across / 2 - mouth;
    const double circle = mouth + 0.85 * wall;
    const double sink = std::min(0.5 * (mouth - diameter / 2 + thread_depth(pitch)), 0.2 * height);

    const Hexagon hexagon(across);
    const auto level = [&](double radius, double y) {
        return level_ring(hexagon.angles, radius, y);
    };
    const double slope = chamfer_slope(across, circle, height);
    // From the lower mouth of the bore outwards, up the sides and inwards to the upper mouth.
    std::vector<SpaceRing> rings{level(mouth, 0),
                                 level(circle, 0),
                                 hexagon.chamfered(0, circle, -slope),
                                 hexagon.chamfered(height, circle, slope),
                                 level(circle, height),
                                 level(mouth, height)};
    if (!params.flag("thread")) {
        const double bore = diameter / 2;
        rings.push_back(level(bore, height - sink));
        rings.push_back(level(bore, sink));
        rings.push_back(level(mouth, 0));
        return finished(loft(rings));
    }
    check_turns(params, height, pitch, diameter);
    Mesh mesh = loft(rings);
    append(mesh, thread_surface(hexagon.angles, {.pitch = pitch,
                                                 .root_radius = diameter / 2,
                                                 .crest_radius = diameter / 2 - thread_depth(pitch),
                                                 .end_radius = mouth,
                                                 .bottom = 0,
                                                 .top = height,
                                                 .fade = sink}));
    return finished(std::move(mesh));
}

ParamSpec pitch_spec() {
    return optional_metres("pitch", "Rise of the thread per turn; ISO 261 coarse by default.");
}

} // namespace

Plugin<MakeMesh> bolt_component() {
    return component(
        "bolt", "A hexagon head bolt with a helical thread.",
        {metres("diameter", "Nominal diameter: 0.008 is M8.", 0.008),
         metres("length", "From under the head to the end.", 0.035),
         optional_metres("thread", "Threaded length; 2.75 diameters by default (ISO 888, M8)."),
         pitch_spec(),
         optional_metres("head_width", "Across the flats; 1.6 diameters by default."),
         optional_metres("head_height", "Height of the head; 0.65 diameters by default."),
         {.name = "pose",
          .type = ParamType::choice,
          .doc = "Lying on its side, or standing on its head.",
          .fallback = std::string("lying"),
          .choices = {"lying", "standing"}}},
        bolt);
}

Plugin<MakeMesh> nut_component() {
    return component("nut", "A hexagon nut with chamfered corners, lying flat.",
                     {metres("diameter", "Nominal diameter of the bore: 0.008 is M8.", 0.008),
                      pitch_spec(),
                      optional_metres("width", "Across the flats; 1.6 diameters by default."),
                      optional_metres("height", "Height; 0.84 diameters by default."),
                      {.name = "thread",
                       .type = ParamType::boolean,
                       .doc = "A helical thread in the bore; without it the bore is plain.",
                       .fallback = true}},
                     nut);
}

} // namespace scree
