// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"
#include "generators/leather/displaced_surface.h"
#include "generators/leather/tile_repeats.h"
#include "shapes/table.h"
#include "tests/support/errors.h"
#include "tests/support/folder.h"
#include "tests/support/leather.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scree {
namespace {

using tests::leather;
using tests::preset;
using tests::request;

TEST(Leather, TheFileHoldsTheHeightsOfTheSwatchThatIsRendered) {
    Params params = leather("coarse_grain", 64);
    params.set("triangles", std::int64_t{2 * 128 * 128}); // every second vertex on a pixel's centre
    const Aggregate made = leather_plugin().make(params)({});
    const test::Folder folder;
    const std::string path = folder.file("swatch.exr");
    write_height(path, *made.height);
    const HeightField map = read_height(path);
    const Image raw = read_data_image(path);
    const Mesh& mesh = *made.prototypes[0].mesh();
    ASSERT_EQ(mesh.positions.size(), 129U * 129);
    std::size_t centres = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec2f& uv = mesh.uvs[i];
        const Vec3& p = mesh.positions[i];
        EXPECT_NEAR(p.y, map.height(Vec2(uv)), 2e-8); // 64 pixels * 2^-24 * the steepest slope
        EXPECT_NEAR(p.x, 0.04 * (uv.x - 0.5), 1e-8);
        EXPECT_NEAR(p.z, 0.04 * (0.5 - uv.y), 1e-8);
        const std::size_t x = i % 129, y = i / 129;
        if (x % 2 == 1 && y % 2 == 1) {
            EXPECT_NEAR(p.y, *raw.at(int(x / 2), int(y / 2)), 1e-9);
            ++centres;
        }
    }
    EXPECT_EQ(centres, 64U * 64);
}

TEST(Leather, FinerEdgesNeedMoreTriangles) {
    Mesh square; // of 1 m, with a diagonal of 1.41 m
    square.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(triangles_needed(square, 1.5, 1000), 2U);
    EXPECT_EQ(triangles_needed(square, 1.1, 1000), 4U); // the diagonals are halved
    EXPECT_EQ(triangles_needed(square, 0.6, 1000), 16U);
    EXPECT_GT(triangles_needed(square, 0.01, 1000), 1000U) << "counting stops";
}

TEST(Leather, TheSwatchHasCutEdgesWhenItIsThick) {
    Params params = leather("pebbled", 64);
    params.set("thickness", 0.002);
    constexpr std::size_t side = 62; // the most cells for which grid and walls are not too many
    params.set("triangles", std::int64_t{2 * 64 * 64});
    const Mesh mesh = *leather_plugin().make(params)({}).prototypes[0].mesh();
    EXPECT_EQ(mesh.triangles.size(), 2 * side * side + 4 * 2 * side);
    EXPECT_LE(mesh.triangles.size(), 2U * 64 * 64);
    const Box3 box = bounds(mesh);
    EXPECT_EQ(box.min.y, 0);
    EXPECT_GT(box.max.y, 0.002F);
    const MeshFacts facts = inspect(mesh);
    EXPECT_EQ(facts.boundary_edges, 4 * side) << "open at the bottom only";
    EXPECT_EQ(facts.non_manifold_edges, 0U);
    for (const Mesh::Triangle& t : mesh.triangles) { // every face looks the way its normals do
        const Vec3 face = (mesh.positions[t[1]] - mesh.positions[t[0]])
                              .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
        ASSERT_GT(face.dot(mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]), 0);
    }
}

TEST(Leather, ASphereIsDisplacedAlongItsRadii) {
    const HeightField field = leather_relief(request(preset("coarse_grain"), 256), {});
    const Vec3 centre(0.1F, 0.2F, -0.3F);
    const Mesh mesh = displaced_sphere(field, centre, 0.02, {0.3F, 0.2F, 1.0F}, 60000);
    EXPECT_NEAR(double(mesh.triangles.size()), 60000, 1000);
    const auto [low, high] =
        std::minmax_element(field.image.pixels.begin(), field.image.pixels.end());
    const float slack = 0.1F * (*high - *low); // cubic interpolation overshoots a little

    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 from = mesh.positions[i] - centre;
        ASSERT_GT(from.length(), 0.02F + *low - slack);
        ASSERT_LT(from.length(), 0.02F + *high + slack);
        ASSERT_NEAR(mesh.normals[i].length(), 1, 1e-5);
        ASSERT_GT(mesh.normals[i].dot(from), 0);
    }
    Mesh closed = mesh;
    for (Vec3& p : closed.positions)
        p -= centre;
    const double enclosed = volume(closed);
    EXPECT_NEAR(enclosed / (4.0 / 3 * pi * std::pow(0.02, 3)), 1, 0.06);
    // Triangles have one size, for the map is laid on without changing areas.
    double smallest = 1, largest = 0;
    for (std::size_t k = 0; k < mesh.triangles.size(); k += 2) {
        const Mesh::Triangle& t = mesh.triangles[k];
        const Vec3 a = (mesh.positions[t[0]] - centre).normalized();
        if (a.dot(Vec3(0.3F, 0.2F, 1.0F).normalized()) < 0)
            continue; // the side that is not seen
        const Vec3 b = (mesh.positions[t[1]] - centre).normalized();
        const Vec3 c = (mesh.positions[t[2]] - centre).normalized();
        const double size = (b - a).cross(c - a).length();
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
    }
    EXPECT_LT(largest / smallest, 1.6);
}

TEST(Leather, AClosedMeshStaysClosedAndTheTileKeepsItsSize) {
    const Registry<MakeMesh> table = component_table();
    for (const Plugin<MakeMesh>& plugin : table.plugins()) {
        if (plugin.name != "torus" && plugin.name != "cylinder" && plugin.name != "box")
            continue;
        const Mesh mesh = plugin.make(tests::defaults(plugin.params, "mesh." + plugin.name));
        ASSERT_FALSE(mesh.uvs.empty());
        HeightField field = leather_relief(request(preset("coarse_grain"), 128, 0.02), {});
        const Mesh displaced = displaced_mesh(field, mesh, 60000, 2e-3);
        EXPECT_GT(displaced.triangles.size(), 30000U) << plugin.name;
        EXPECT_LE(displaced.triangles.size(), 60000U) << plugin.name;
        const MeshFacts before = inspect(mesh), after = inspect(displaced);
        ASSERT_TRUE(before.closed()) << plugin.name;
        EXPECT_TRUE(after.closed())
            << plugin.name << ": " << after.boundary_edges << " " << after.non_manifold_edges;
        EXPECT_TRUE(after.finite);
        EXPECT_NEAR(volume(displaced) / volume(mesh), 1, 0.15) << plugin.name;
    }
}

// A wave over a box whose sides show different places of it: across the seams it must not rise more
// steeply than the blend does.
TEST(Leather, SeamsAreBlended) {
    const Registry<MakeMesh> table = component_table();
    const Mesh box = tests::make(
        table, "box",
        {{"width", 0.08}, {"height", 0.05}, {"depth", 0.06}, {"uvs", std::string("even")}});
    HeightField wave{.image = Image(64, 64, {"Y"}), .size = {0.02, 0.02}};
    const double height = 2e-4;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            *wave.image.at(x, y) =
                static_cast<float>(height * std::sin(2 * pi * x / 64) * std::cos(2 * pi * y / 64));
    HeightField low = wave; // bends where the wave does, so that the same edges are halved
    for (float& value : low.image.pixels)
        value *= 0x1p-20F;
    const Mesh flat = displaced_mesh(low, box, 200000, 1e-3);
    const double blend = 4e-3;
    const double slope = 1.5 * (2 * pi * height / wave.size.x + 1.5 * height / blend);
    const auto highest_step = [&](double width) { // that the slope does not explain
        const Mesh mesh = displaced_mesh(wave, box, 200000, width);
        double highest = 0;
        for (const Mesh::Triangle& t : mesh.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                const Vec3 rise = (mesh.positions[b] - flat.positions[b]) -
                                  (mesh.positions[a] - flat.positions[a]);
                const Vec3 way = flat.positions[b] - flat.positions[a];
                highest = std::max(highest, double(rise.length()) - slope * double(way.length()));
            }
        return highest;
    };
    EXPECT_LT(highest_step(blend), 0.05 * height) << "at corners, where three sides meet";
    EXPECT_GT(highest_step(1e-9), 0.5 * height) << "a blend is needed";
}

TEST(Leather, StandsAsHighAsTheBareShape) {
    const Registry<MakeMesh> table = component_table();
    Params params = leather("pebbled", 64);
    params.set("shape", std::make_shared<const Mesh>(tests::make(table, "box", {{"width", 0.08}})));
    const Aggregate made = leather_plugin().make(params)({});
    EXPECT_NEAR(bounds(*made.prototypes[0].mesh()).min.y, 0, 1e-8);
}

TEST(Leather, TheStretchOfATileIsThatOfTheUvs) {
    const Registry<MakeMesh> table = component_table();
    const auto stretch = [&](const std::string& name, const std::map<std::string, Value>& values) {
        return tile_stretch(tests::make(table, name, values), {0.05, 0.05});
    };
    const std::map<std::string, Value> plate{
        {"width", 0.2}, {"height", 0.1}, {"depth", 0.05}, {"rounding", 0.0}};
    // Lengths of u: x, z, y, and of v: y, x, z of the sides across z, y and x, by their areas.
    EXPECT_GT(stretch("box", plate), 2);
    std::map<std::string, Value> even = plate;
    even["uvs"] = std::string("even");
    EXPECT_NEAR(stretch("box", even), 1, 1e-5) << "0.2 m are four tiles";
    EXPECT_NEAR(stretch("plane", {{"size", 0.1}, {"depth", 0.2}}), 1, 1e-5);
    EXPECT_NEAR(stretch("plane", {{"size", 0.02}}), 2.5, 1e-5) << "a whole tile on 2 cm";
    EXPECT_NEAR(stretch("plane", {{"size", 0.07}}), 1.4, 1e-5) << "one tile on 7 cm";
}

TEST(Leather, AMeshWithoutUvsIsNamed) {
    Mesh bare;
    bare.name = "bare.obj";
    bare.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    bare.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    Params params = leather("pebbled", 64);
    params.set("shape", std::make_shared<const Mesh>(bare), {"scene.lua", 12});
    EXPECT_EQ(tests::error_of([&] { leather_plugin().make(params)({}); }),
              "scene.lua:12: generator.leather.shape: bare.obj has no UVs to lay the leather on");
}

TEST(Leather, CanBeCancelled) {
    Cancel cancel;
    cancel.request();
    Context context;
    context.cancel = &cancel;
    EXPECT_THROW(leather_plugin().make(leather("reptile"))(context), Cancelled);
}

} // namespace
} // namespace scree
