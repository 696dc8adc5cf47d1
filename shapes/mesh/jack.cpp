// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/component.h"
#include "shapes/mesh/implicit.h"

#include <algorithm>

namespace scree {

namespace {

// The signed field of a jack: six arms from -1 to 1 along the axes. The pair along z ends in
// points, the others end in balls.
double field(const Vec3d& p, double arm, double ball, double point) {
    double distance = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = std::abs(p[axis]);
        const double across = std::hypot(p[(axis + 1) % 3], p[(axis + 2) % 3]);
        const Vec3d q(along, across, 0);
        double limb = 0;
        if (axis == 2) { // a rod that tapers to a rounded point
            const double slim = arm * (1.15 - 0.6 * along / point);
            limb = capsule(q, {0, 0, 0}, {point, 0, 0}, slim);
        } else {
            limb = smooth_union(capsule(q, {0, 0, 0}, {1 - ball, 0, 0}, arm),
                                (q - Vec3d(1 - ball, 0, 0)).length() - ball, 0.8 * arm);
        }
        distance = axis == 0 ? limb : smooth_union(distance, limb, 1.6 * arm);
    }
    return distance;
}

Mesh jack(const Params& params) {
    const double arm = params.number("arm");
    const double ball = std::max(params.number("ball"), 1.1 * arm);
    // The centre of a pointed arm's rounded end, chosen so that this end and those of two arms with
    // balls touch the ground together.
    const double point = 1 - ball + std::sqrt(3.0) * (ball - 0.55 * arm);
    const double half = point + arm + 0.05;
    Mesh mesh = polygonise([&](const Vec3d& p) { return field(p, arm, ball, point); },
                           {Vec3d(-half), Vec3d(half)}, std::min(2.0 / 42, 0.42 * arm));
    // Stands on the ends of three arms: the diagonal of the other three becomes the y axis.
    const Matrix tilt = Matrix().setAxisAngle(Vec3(1, 0, -1).normalized(),
                                              static_cast<float>(std::acos(1 / std::sqrt(3.0))));
    transform(mesh, tilt);
    Matrix scale;
    scale.setScale(static_cast<float>(params.number("size") / 2));
    transform(mesh, scale);
    return mesh;
}

} // namespace

Plugin<MakeMesh> jack_component() {
    return component(
        "jack", "The six-armed toy jack, resting on three of its arms.",
        {metres("size", "From end to end of two opposite balls.", 0.022),
         ratio("arm", "Radius of the arms as a share of half the size.", 0.115, 0.06, 0.25),
         ratio("ball", "Radius of the balls as a share of half the size.", 0.21, 0.08, 0.32)},
        jack);
}

} // namespace scree
