// SPDX-License-Identifier: GPL-3.0-or-later
// Materials that a program adds at run time, and frames that follow the tangent.
#include "core/random.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

// Sends all light upwards along the tangent.
class AlongTangent final : public Lobe {
  public:
    AlongTangent() : Lobe({.oriented = true}) {}
    BsdfValue evaluate(const Bsdf&, const Vec3&, const Vec3&, float) const override { return {}; }
    BsdfSample sample(const Bsdf& at, const Vec3&, float, const Vec2f&) const override {
        return {unit(Vec3(1.0F, 0.0F, 1.0F)), at.color, 1, true};
    }
};

class Brushed final : public CustomMaterial {
  public:
    const Paint* paint() const override { return &paint_; }
    bool oriented() const override { return true; }
    std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables&) const override {
        return std::make_unique<const ColoredLobe<AlongTangent>>(paint_);
    }

  private:
    Paint paint_{{Color(0.25F, 0.5F, 0.75F), nullptr}, {}};
};

// A square metre that faces up; u grows along z.
Mesh square() {
    Mesh mesh = test::make_plane(1);
    for (const Vec3& p : mesh.positions)
        mesh.uvs.emplace_back(p.z + 0.5F, p.x + 0.5F);
    return mesh;
}

TEST(CustomMaterial, ItsLobeIsTurnedByTheTangent) {
    Matrix turned;
    turned.setAxisAngle(unit(Vec3(1.0F, 2.0F, 3.0F)), 0.7F);
    test::Stage stage;
    stage.add(square(), std::make_shared<const Brushed>(), turned);
    const World world(stage.aggregates, {});
    const Vec3 up = transform_direction(turned, Vec3(0.0F, 1.0F, 0.0F));
    const Vec3 along = transform_direction(turned, Vec3(0.0F, 0.0F, 1.0F));
    Hit hit;
    ASSERT_TRUE(world.hit({up, -up}, hit));
    const MaterialSet materials(world.materials());
    Painted painted;
    painted.color = Color(0.25F);
    const Surface surface = materials.surface(hit, -up, painted);
    const BsdfSample sample = surface.sample(0, {0.0F, 0.0F});
    EXPECT_LT((sample.direction - unit(along + up)).length(), 1e-5F);
    EXPECT_EQ(sample.weight, Color(0.25F));
}

TEST(CustomMaterial, IsSeenAsItsPaintInTheAlbedo) {
    test::Stage stage;
    stage.film.width = stage.film.height = 2;
    stage.film.samples = 1;
    stage.camera.from = {0.0F, 1.0F, 0.0F};
    stage.camera.up = {0.0F, 0.0F, 1.0F};
    stage.camera.fov = 0.1F;
    stage.lights.push_back(test::even_sky(1));
    stage.add(square(), std::make_shared<const Brushed>());
    const std::vector<ImagePart> parts = stage.render().film.parts();
    for (int c = 0; c < 3; ++c) {
        const float expected = Color(0.25F, 0.5F, 0.75F)[c];
        EXPECT_FLOAT_EQ(parts[0].image.at(1, 1)[c], expected); // all light goes to the sky
        EXPECT_FLOAT_EQ(parts[1].image.at(1, 1)[c], expected);
    }
}

TEST(Frame, IsOrthonormalWithXByTheTangent) {
    Random random(41, Purpose::test);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 n = test::random_direction(random);
        const Vec3 tangent = test::random_direction(random);
        const Frame frame(n, tangent);
        EXPECT_NEAR(frame.x.dot(frame.x), 1, 1e-5F);
        EXPECT_NEAR(frame.x.dot(n), 0, 1e-5F);
        EXPECT_LT((n.cross(frame.x) - frame.y).length(), 1e-5F);
        EXPECT_NEAR(tangent.dot(frame.y), 0, 1e-5F);
        EXPECT_GE(tangent.dot(frame.x), 0);
    }
    const Vec3 up(0.0F, 0.0F, 1.0F);
    for (const Vec3& useless : {Vec3(0.0F), up})
        EXPECT_EQ(Frame(up, useless).x, Frame(up).x);
}

} // namespace
} // namespace scree
