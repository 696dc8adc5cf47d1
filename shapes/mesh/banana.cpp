// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/component.h"
#include "shapes/mesh/sweep.h"

#include <algorithm>

namespace scree {

namespace {

constexpr int banana_sides = 40;
constexpr int along = 72;

// (share of the length, radius) from the cut stem to the tip; the largest radius is 1.
const std::vector<Vec2>& radius_knots() {
    static const std::vector<Vec2> knots{
        {0.00, 0.27}, {0.03, 0.25}, {0.07, 0.235}, {0.11, 0.25},  {0.15, 0.31},  {0.20, 0.46},
        {0.26, 0.67}, {0.34, 0.86}, {0.44, 0.97},  {0.54, 1.00},  {0.64, 0.985}, {0.74, 0.91},
        {0.82, 0.77}, {0.88, 0.60}, {0.925, 0.41}, {0.955, 0.26}, {0.975, 0.20}, {1.00, 0.185}};
    return knots;
}

// A cross-section with five soft ridges, which are strongest in the middle of the fruit.
Ring section(double radius, double ridge) {
    Ring ring;
    for (int i = 0; i < banana_sides; ++i) {
        const double angle = 2 * pi * i / banana_sides;
        const double five = 5 * (angle - pi / 2);
        const double r =
            radius * (1 + ridge * (0.06 * std::cos(five) + 0.016 * std::cos(2 * five)));
        ring.push_back(rotate({r, 0.0}, angle));
    }
    return ring;
}

Mesh banana(const Params& params) {
    const double widest = params.number("thickness") / 2;
    const double bend = params.number("bend");

    // The curvature is largest where the stem meets the fruit.
    std::vector<double> curvature;
    double sum = 0;
    for (int i = 0; i < 200; ++i) {
        const double t = (i + 0.5) / 200;
        curvature.push_back(0.75 + 0.55 * std::exp(-std::pow((t - 0.22) / 0.13, 2)) +
                            0.25 * std::exp(-std::pow((t - 0.85) / 0.12, 2)));
        sum += curvature.back() / 200;
    }
    for (double& k : curvature)
        k *= bend / sum;
    const BentAxis axis(1, curvature);

    std::vector<SpaceRing> rings;
    const auto add = [&](double t, double radius, double ridge) {
        rings.push_back(axis.place(section(radius * widest, ridge), t));
    };
    // The slightly hollow cut face of the stem, then its rounded rim.
    const double stem = radius_knots().front().y;
    const double rim = 0.06 * stem * widest;
    rings.push_back(axis.place(Ring(banana_sides, Vec2(0.0)), 0.25 * stem * widest));
    add(0.12 * stem * widest, 0.7 * stem, 0);
    add(0, 0.92 * stem, 0.6);
    add(0.3 * rim, 0.975 * stem, 0.6);
    for (int j = 0; j <= along; ++j) {
        const double t = rim + (1 - rim) * j / along;
        const double ridge = std::clamp(std::min(0.6 + 2 * t, (1 - t) * 6), 0.2, 1.0);
        add(t, interpolate(radius_knots(), t), ridge);
    }
    const double tip = radius_knots().back().y;
    add(1 + 0.05 * tip * widest, 0.95 * tip, 0);
    add(1 + 0.12 * tip * widest, 0.8 * tip, 0);
    add(1 + 0.10 * tip * widest, 0.45 * tip, 0);
    rings.push_back(axis.place(Ring(banana_sides, Vec2(0.0)), 1 + 0.08 * tip * widest));

    Mesh mesh = loft(rings);
    // Rotated so that the chord from stem to tip lies along x.
    const Vec3 chord = rings.back().front() - rings.front().front();
    transform(mesh, Matrix().setEulerAngles(Vec3(0, std::atan2(chord.z, chord.x), 0)));
    normalise_size(mesh, params.number("length"));
    compute_normals(mesh, radians(40));
    return mesh;
}

} // namespace

Plugin<MakeMesh> banana_component() {
    return component("banana", "A banana lying on its side, with five soft ridges, stem and tip.",
                     {metres("length", "Longest side of its bounding box.", 0.18),
                      ratio("thickness", "Greatest width as a share of the length along the curve.",
                            0.185, 0.05, 0.35),
                      angle_degrees("bend", "How far it turns from stem to tip.", 95, 0, 150)},
                     banana);
}

} // namespace scree
