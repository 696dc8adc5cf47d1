// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/component.h"
#include "shapes/mesh/implicit.h"

#include <algorithm>

namespace scree {

namespace {

Vec3d turned(const Vec3d& p, const Vec3d& pivot, double angle) { // about z
    const Vec2 q = rotate({p.x - pivot.x, p.y - pivot.y}, -angle);
    return {pivot.x + q.x, pivot.y + q.y, p.z};
}

// The signed field of a bath duck of about unit length that faces +x.
double field(const Vec3d& point) {
    const Vec3d p(point.x, point.y, std::abs(point.z));
    double body = ellipsoid(p, {0, 0, 0}, {0.46, 0.30, 0.335});
    body = smooth_union(body, ellipsoid(p, {0.16, 0.03, 0}, {0.29, 0.28, 0.29}), 0.1);
    // Tail, pointing up and back.
    const Vec3d tail = turned(p, {-0.40, 0.15, 0}, radians(-38));
    body = smooth_union(body, ellipsoid(tail, {-0.40, 0.15, 0}, {0.19, 0.075, 0.14}), 0.16);
    // Wings.
    const Vec3d wing = turned(p, {-0.06, 0.05, 0}, radians(-14));
    body = smooth_union(body, ellipsoid(wing, {-0.08, 0.06, 0.30}, {0.25, 0.125, 0.07}), 0.035);
    const Vec3d wing_tip = turned(p, {-0.28, 0.13, 0}, radians(-30));
    body = smooth_union(body, ellipsoid(wing_tip, {-0.27, 0.125, 0.31}, {0.10, 0.05, 0.045}), 0.06);
    // Neck and head.
    body = smooth_union(body, ellipsoid(p, {0.25, 0.28, 0}, {0.16, 0.17, 0.155}), 0.14);
    body = smooth_union(body, ellipsoid(p, {0.275, 0.475, 0}, {0.215, 0.205, 0.20}), 0.05);
    // Beak, with an upturned bill.
    const Vec3d bill = turned(p, {0.46, 0.44, 0}, radians(10));
    body = smooth_union(body, ellipsoid(bill, {0.50, 0.435, 0}, {0.125, 0.05, 0.10}), 0.035);
    body = smooth_union(body, ellipsoid(p, {0.475, 0.405, 0}, {0.095, 0.045, 0.075}), 0.02);
    // Eyes.
    body = smooth_union(body, (p - Vec3d(0.371, 0.524, 0.106)).length() - 0.072, 0.008);
    // A flat base.
    const double foot = -0.235 - p.y;
    return -smooth_union(-body, -foot, 0.05);
}

Mesh duck(const Params& params) {
    Mesh mesh = polygonise(field, {Vec3d(-0.75, -0.32, -0.48), Vec3d(0.75, 0.78, 0.48)},
                           1.0 / double(params.integer("detail")));
    normalise_size(mesh, params.number("length"));
    return mesh;
}

} // namespace

Plugin<MakeMesh> duck_component() {
    return component("duck", "A bath duck that looks along +x.",
                     {metres("length", "Longest side of its bounding box.", 0.09),
                      count("detail", "Cells along its length.", 48, 40, 160)},
                     duck);
}

} // namespace scree
