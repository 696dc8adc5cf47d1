// SPDX-License-Identifier: GPL-3.0-or-later
// mesh.lathe and mesh.cut_sphere against closed forms.
#include "tests/support/component_checks.h"

#include <map>

namespace scree {
namespace {

using tests::area_of_wrong_normals;
using tests::component_mesh;
using tests::expect_sound;

std::vector<Vec2> reversed(const std::vector<Vec2>& profile) {
    return {profile.rbegin(), profile.rend()};
}

// Exact for the revolved polygon, times the area ratio of the approximating polygon to the circle.
TEST(Lathe, Volumes) {
    const int segments = 180;
    const double share = segments / (2 * pi) * std::sin(2 * pi / segments);
    const auto volume_of = [&](const std::vector<Vec2>& profile, bool closed, bool spline) {
        double first = 0;
        for (const auto& points : {profile, reversed(profile)}) { // in both directions
            const Mesh mesh = component_mesh("lathe", {{"profile", points},
                                                       {"closed", closed},
                                                       {"spline", spline},
                                                       {"steps", std::int64_t{40}},
                                                       {"segments", std::int64_t{segments}}});
            expect_sound(mesh, "lathe");
            EXPECT_LT(area_of_wrong_normals(mesh), 1e-3 * area(mesh));
            if (first > 0) {
                EXPECT_NEAR(volume(mesh) / first, 1, 1e-5);
            }
            first = volume(mesh);
        }
        return first / share;
    };
    // A cylinder closed by discs, a cone, a tube, and a ring with a square cross-section.
    EXPECT_NEAR(volume_of({{0.5, 0}, {0.5, 2}}, false, false), pi * 0.25 * 2, 1e-5);
    EXPECT_NEAR(volume_of({{0.5, 0}, {0, 2}, {0, 2}}, false, true), pi * 0.25 * 2 / 3, 1e-5);
    const std::vector<Vec2> square{{0.3, 0}, {0.5, 0}, {0.5, 0.2}, {0.3, 0.2}};
    EXPECT_NEAR(volume_of(square, true, false), pi * (0.25 - 0.09) * 0.2, 1e-6);
    std::vector<Vec2> corners;
    for (const Vec2& p : square)
        corners.insert(corners.end(), {p, p});
    EXPECT_NEAR(volume_of(corners, true, true), pi * (0.25 - 0.09) * 0.2, 1e-6);
    // A spline through points of a circle is almost a circle: a torus and a ball.
    std::vector<Vec2> ring;
    std::vector<Vec2> half;
    for (int i = 0; i < 24; ++i) {
        const double angle = 2 * pi * i / 24;
        ring.emplace_back(0.5 + 0.2 * std::cos(angle), 0.2 * std::sin(angle));
        if (i <= 12)
            half.emplace_back(i % 12 == 0 ? 0.0 : std::sin(angle), -std::cos(angle));
    }
    EXPECT_NEAR(volume_of(ring, true, true) / (2 * pi * pi * 0.5 * 0.04), 1, 2e-3);
    EXPECT_NEAR(volume_of(half, false, true) / (4.0 / 3 * pi), 1, 2e-3);
    EXPECT_NEAR(bounds(component_mesh("lathe", {{"profile", half}, {"height", 7.0}})).size().y, 7,
                1e-5);
}

// A repeated point is a sharp edge, any other point is smooth, and the curve meets the axis at a
// right angle.
TEST(Lathe, Corners) {
    const std::vector<Vec2> profile{{0, 0}, {0.4, 0}, {0.4, 0}, {0.5, 0.5}, {0.4, 1}, {0, 1.2}};
    const Mesh mesh = component_mesh("lathe", {{"profile", profile}});
    std::map<float, std::vector<Vec3>> normals; // along one meridian, by height
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.uvs[i].x == 0)
            normals[mesh.positions[i].y].push_back(mesh.normals[i]);
    EXPECT_EQ(normals.begin()->second.size(), 3U); // centre, and both sides of the edge
    EXPECT_EQ(normals.begin()->second[1].y, -1.0F);
    EXPECT_GT(normals.begin()->second[2].x, 0.9F);
    EXPECT_EQ(normals[0.5F].size(), 1U);
    EXPECT_EQ(normals.rbegin()->second.front().y, 1.0F);
}

TEST(CutSphere, Volumes) {
    const double ball = 4.0 / 3 * pi;
    const auto volume_of = [&](double degrees, double floor) {
        const Mesh mesh = component_mesh("cut_sphere", {{"radius", 1.0},
                                                        {"angle", radians(degrees)},
                                                        {"floor", floor},
                                                        {"segments", std::int64_t{256}}});
        expect_sound(mesh, "cut_sphere");
        EXPECT_LT(area_of_wrong_normals(mesh), 1e-3 * area(mesh));
        return volume(mesh);
    };
    EXPECT_NEAR(volume_of(90, 0), 7.0 / 8 * ball, 2e-3);
    EXPECT_NEAR(volume_of(90, -1), 3.0 / 4 * ball, 2e-3);
    EXPECT_NEAR(volume_of(200, -1), 160.0 / 360 * ball, 2e-3);
    const double cap = pi * 0.25 * (1 - 0.5 / 3); // of height 0.5
    EXPECT_NEAR(volume_of(120, 0.5), ball - cap / 3, 2e-3);
}

} // namespace
} // namespace scree
