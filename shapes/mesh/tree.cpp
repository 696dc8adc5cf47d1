// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/component.h"
#include "shapes/mesh/implicit.h"
#include "shapes/mesh/loft.h"
#include "shapes/mesh/outline.h"

#include "core/random.h"

#include <algorithm>

namespace scree {

namespace {

// All trees are 1 high and stand on y = 0.

// A crown of round tufts on a trunk that widens at the foot.
Mesh round_tree(double width, double trunk, std::uint64_t seed) {
    const Vec3d middle(0, 0.66, 0);
    const Vec3d reach(width / 2, 0.34, width / 2);
    struct Tuft {
        Vec3d center;
        double radius;
    };
    std::vector<Tuft> tufts;
    constexpr int count = 16;
    Random random(seed, Purpose::mesh_shape);
    for (int i = 0; i < count; ++i) { // on a spiral over the crown (Vogel 1979), jittered
        const double height = 1 - 2 * (i + 0.5) / count;
        const double angle = i * pi * (3 - std::sqrt(5.0)) + random.uniform(-0.35, 0.35);
        const double ring = std::sqrt(1 - height * height);
        const double radius = random.uniform(0.36, 0.46) * std::min(reach.x, reach.y);
        const Vec3d out(ring * std::cos(angle), height, ring * std::sin(angle));
        tufts.push_back({middle + out * (reach - Vec3d(radius)), radius});
    }
    const auto field = [&](const Vec3d& p) {
        double crown = ellipsoid(p, middle, reach * 0.8);
        for (const Tuft& tuft : tufts)
            crown = smooth_union(crown, (p - tuft.center).length() - tuft.radius, 0.055);
        const double spread = std::max(0.0, 1 - p.y / 0.12);
        const double wood =
            capsule(p, {0, -0.2, 0}, {0, 0.6, 0}, trunk * (1 + 0.6 * spread * spread));
        const double ground = -p.y;
        return -smooth_union(-smooth_union(crown, wood * 0.9, 0.06), -ground, 0.035);
    };
    const double side = std::max(0.56 * width, 2.5 * trunk);
    return polygonise(field, {Vec3d(-side, -0.06, -side), Vec3d(side, 1.06, side)},
                      std::min(1.0 / 44, 0.6 * trunk));
}

// A toy fir of stacked skirts.
Mesh conifer(double width, double trunk, int tiers) {
    const double foot = 0.2; // height of the trunk
    const double rounding = 0.03 * width;
    std::vector<Corner> profile{{0, 0}, {trunk * 1.15, 0, 0.2 * trunk}, {trunk, foot, 0.01}};
    for (int k = 0; k < tiers; ++k) {
        const double low = foot + (1 - foot) * k / (tiers + 0.35);
        const double next = foot + (1 - foot) * (k + 1) / (tiers + 0.35);
        const double share = double(k) / tiers;
        const double reach = width / 2 * std::pow(1 - share, 0.85);
        const double top = k + 1 == tiers ? 0.006 : 0.42 * width / 2 * (1 - share);
        profile.push_back({reach * 0.93, low, rounding});
        profile.push_back({reach, low + 0.025, rounding});
        profile.push_back(
            {std::max(top, 0.006), k + 1 == tiers ? 1.0 : next, k + 1 == tiers ? 0.012 : 0.02});
    }
    profile.push_back({0, 1});
    Mesh mesh = revolve(round_curve(profile, 5), 48);
    compute_normals(mesh, radians(35));
    return mesh;
}

// One smooth egg-shaped crown.
Mesh poplar(double width, double trunk) {
    const double low = 0.2;
    std::vector<Corner> profile{{0, 0}, {trunk * 1.3, 0, 0.2 * trunk}, {trunk, 0.1, 0.3}};
    constexpr int steps = 40;
    for (int i = 1; i < steps; ++i) {
        const double angle = -pi / 2 + pi * i / steps;
        const double y = low + (1 - low) * (0.5 + 0.5 * std::sin(angle));
        const double r = width / 2 * std::cos(angle) * (1 - 0.28 * std::sin(angle)) / 1.03;
        if (r > 1.05 * trunk || i > steps / 2)
            profile.push_back({r, y});
    }
    profile.push_back({0, 1});
    Mesh mesh = revolve(round_curve(profile, 6), 48);
    compute_normals(mesh, radians(50));
    return mesh;
}

Mesh tree(const Params& params) {
    const std::string& style = params.text("style");
    const double width = params.number("width");
    const double trunk = params.number("trunk") / 2;
    if (2.5 * trunk > width)
        throw params.error("trunk", "must be at most 0.8 of the width");
    Mesh mesh = style == "conifer" ? conifer(width, trunk, int(params.integer("tiers")))
                : style == "poplar"
                    ? poplar(width, trunk)
                    : round_tree(width, trunk, std::uint64_t(params.integer("seed")));
    Matrix scale;
    scale.setScale(static_cast<float>(params.number("height")) / bounds(mesh).size().y);
    transform(mesh, scale);
    return mesh;
}

} // namespace

Plugin<MakeMesh> tree_component() {
    return component(
        "tree", "A toy tree that stands: trunk and crown in one piece.",
        {{.name = "style",
          .type = ParamType::choice,
          .doc = "Round tufts, stacked skirts, or one smooth crown.",
          .fallback = std::string("round"),
          .choices = {"round", "conifer", "poplar"}},
         metres("height", "Height of the tree.", 0.09),
         ratio("width", "Width of the crown as a share of the height.", 0.6, 0.3, 1),
         ratio("trunk", "Width of the trunk as a share of the height.", 0.1, 0.05, 0.2),
         count("tiers", "Skirts of a conifer.", 3, 1, 8),
         count("seed", "Arrangement of round tufts.", 1, 0, 1000000000)},
        tree);
}

} // namespace scree
