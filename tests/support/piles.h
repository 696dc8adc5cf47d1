// SPDX-License-Identifier: GPL-3.0-or-later
// Components and brute-force measures for the tests of generator.pile.
#pragma once

#include "core/parallel.h"
#include "generators/pile/pile_generator.h"
#include "generators/pile/pile_kind.h"
#include "geometry/bodies/advance.h"
#include "tests/support/aggregates.h"
#include "tests/support/component_checks.h"
#include "tests/support/layout_params.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace scree::tests {

inline std::shared_ptr<const Body> body_of(Mesh mesh, double thickness = 0) {
    return make_body(std::make_shared<const Mesh>(std::move(mesh)), thickness);
}

/// A component with random rotations about all axes.
inline PileKind kind_of(const Mesh& mesh, double spacing, double refine) {
    const std::shared_ptr<const Body> body = body_of(mesh);
    return {.body = body,
            .unit_radius = unit_radius_of(*body),
            .spacing = spacing,
            .refine = refine,
            .rotation = Vec3(2 * pi_f)};
}

/// Distance from p to a triangle: the minimum over its sides and, if the projection of p lies
/// inside, the distance to its plane.
inline double triangle_distance(const Imath::V3d& p, const std::array<Imath::V3d, 3>& v) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < 3; ++k) {
        const Imath::V3d& a = v[k];
        const Imath::V3d ab = v[(k + 1) % 3] - a;
        const double length2 = ab.length2();
        const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
        least = std::min(least, (p - a - ab * t).length());
    }
    const Imath::V3d normal = (v[1] - v[0]).cross(v[2] - v[0]);
    if (normal.length2() == 0)
        return least;
    for (std::size_t k = 0; k < 3; ++k)
        if ((v[(k + 1) % 3] - v[k]).cross(p - v[k]).dot(normal) < 0)
            return least;
    return std::min(least, std::abs((p - v[0]).dot(normal)) / normal.length());
}

/// Signed distance to a closed mesh, negative inside, by brute force over all triangles; the sign
/// is that of their solid angle at p (van Oosterom & Strackee 1983).
inline double signed_distance(const Mesh& mesh, const Imath::V3d& p) {
    double least = std::numeric_limits<double>::max();
    double angle = 0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        std::array<Imath::V3d, 3> v;
        for (std::size_t k = 0; k < 3; ++k)
            v[k] = Imath::V3d(mesh.positions[t[k]]);
        least = std::min(least, triangle_distance(p, v));
        const Imath::V3d a = v[0] - p, b = v[1] - p, c = v[2] - p;
        const double la = a.length(), lb = b.length(), lc = c.length();
        angle += 2 * std::atan2(a.dot(b.cross(c)),
                                la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return std::abs(angle) > 2 * pi ? -least : least;
}

/// How deep any vertex of an instance is in another instance [m], for a pile of one closed mesh.
inline double deepest_vertex(const Aggregate& pile, const Mesh& mesh) {
    const Box3 box = bounds(mesh);
    double deepest = 0;
    for (const Instance& a : pile.instances)
        for (const Instance& b : pile.instances) {
            if (&a == &b)
                continue;
            const Imath::M44d there =
                Imath::M44d(a.world_from_object) * Imath::M44d(b.world_from_object).inverse();
            for (const Vec3& vertex : mesh.positions) {
                const Imath::V3d p = Imath::V3d(vertex) * there;
                if (box.intersects(Vec3(p)))
                    deepest = std::max(deepest, -signed_distance(mesh, p));
            }
        }
    return deepest;
}

/// The parameters of a component at their defaults.
inline Params pile_component(const Mesh& mesh) {
    for (const ParamSpec& spec : pile_plugin().params)
        if (spec.name == "components") {
            Params params = defaults(spec.fields, "generator.pile.components[1]");
            params.set("shape", std::make_shared<const Mesh>(mesh), {"scene.lua", 20});
            return params;
        }
    return {};
}

/// Parameters of a pile with a single pass.
inline Params pile_params(const Mesh& target, std::vector<Params> components) {
    Params params = defaults(pile_plugin().params, "generator.pile");
    params.set("target", std::make_shared<const Mesh>(target), {"scene.lua", 9});
    params.set("components", std::make_shared<const std::vector<Params>>(std::move(components)),
               {"scene.lua", 10});
    params.set("cover", 0.0);
    return params;
}

/// How deep a body reaches into any other of the pile [m]; negative: the gap to the nearest one.
inline float greatest_depth(const PlacedBodies& pile, std::size_t body) {
    float deepest = -1;
    for (std::size_t other = 0; other < pile.all.size(); ++other)
        if (other != body)
            deepest = std::max(deepest,
                               depth_between(pile.body(pile.all[body]), pile.all[body].pose,
                                             pile.body(pile.all[other]), pile.all[other].pose, -1));
    return deepest;
}

/// Expects that `bake()` gives bit-identical instances on 1, 2 and 7 threads.
template <class Bake>
void expect_same_on_any_threads(const Bake& bake) {
    std::vector<Aggregate> piles;
    for (const int threads : {1, 2, 7}) {
        const ThreadLimit limit(threads);
        piles.push_back(bake());
    }
    for (const Aggregate& pile : piles) {
        ASSERT_EQ(pile.instances.size(), piles[0].instances.size());
        for (std::size_t i = 0; i < pile.instances.size(); ++i)
            ASSERT_EQ(std::memcmp(&pile.instances[i].world_from_object,
                                  &piles[0].instances[i].world_from_object, sizeof(WideMatrix)),
                      0);
    }
}

} // namespace scree::tests
