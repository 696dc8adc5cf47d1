// SPDX-License-Identifier: GPL-3.0-or-later
// Materials that mesh files bring: read, made, and seen at the triangles to which they belong.
#include "core/error.h"
#include "core/file.h"
#include "core/image.h"
#include "formats/read_mesh.h"
#include "geometry/mesh/mesh_material.h"
#include "model/file_material.h"
#include "render/paint.h"
#include "tests/support/folder.h"
#include "tests/support/gltf_builder.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include <functional>

namespace scree {
namespace {

using namespace tests;

/// The parameters of an object whose material is this word, and the warnings they got.
struct Asked {
    Params params{"object", {"a.lua", 3}};
    std::shared_ptr<Warnings> warnings = std::make_shared<Warnings>();

    explicit Asked(const std::string& word = "file") {
        params.set("material", word, {"a.lua", 4});
        params.set_warnings(warnings);
    }
    std::string warned() const { return warnings->empty() ? "" : warnings->front().text(); }
};

std::string problem_of(const std::function<void()>& run) {
    try {
        run();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// Quarters of red and green above, blue and white below.
std::string four_colors() {
    constexpr int side = 32;
    Image image(side, side, {"R", "G", "B"});
    const Color colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] = colors[2 * x / side + 2 * (2 * y / side)][c];
    return png_bytes(image);
}

/// Two squares side by side along x, each a primitive with its own material. The UVs of the second
/// are 0 to 1 along x and, from above in the picture, along z.
struct TwoSquares {
    GltfBuilder file;

    TwoSquares() {
        file.mesh(file.square());
        Json other = file.square();
        other["attributes"] = {
            {"POSITION", file.points({{1, 0, 0}, {1, 0, 1}, {2, 0, 0}, {2, 0, 1}})},
            {"TEXCOORD_0", file.floats(2, {0, 0, 0, 1, 1, 0, 1, 1})}};
        Json& primitives = file.json["meshes"][0]["primitives"];
        primitives.push_back(other);
        primitives[0]["material"] = 1;
        primitives[1]["material"] = 0;
        file.scene({file.node({{"mesh", 0}})});
        const Json matte = {{"KHR_materials_specular", {{"specularFactor", 0}}}};
        file.json["images"] = {
            {{"bufferView", file.view(four_colors())}, {"mimeType", "image/png"}}};
        file.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33071}}};
        file.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
        file.json["materials"] = {
            {{"name", "painted"},
             {"extensions", matte},
             {"pbrMetallicRoughness",
              {{"metallicFactor", 0},
               {"baseColorFactor", {0.5, 1, 1, 1}},
               {"baseColorTexture", {{"index", 0}}}}}},
            {{"name", "plain"},
             {"extensions", matte},
             {"pbrMetallicRoughness",
              {{"metallicFactor", 0}, {"baseColorFactor", {0.25, 0.5, 0.75, 1}}}}}};
    }

    Mesh mesh() const { return read_mesh_bytes("two.gltf", file.text()); }

    Aggregate aggregate() const {
        const auto shape = std::make_shared<const Mesh>(mesh());
        Aggregate out;
        out.prototypes.push_back({.name = "two",
                                  .shape = shape,
                                  .materials = materials_of(Asked().params, shape.get())});
        out.instances.push_back({});
        return out;
    }

    /// The colour of what is seen from above at (x, z).
    static Color color_at(const World& world, double x, double z) {
        const Ray ray{Vec3(float(x), 1, float(z)), Vec3(0, -1, 0)};
        Hit hit;
        EXPECT_TRUE(world.hit(ray, hit));
        const PaintQuery query{paint_of(*world.materials()[hit.material]), &hit, ray.direction, 0};
        Painted painted;
        paint({&query, 1}, {&painted, 1});
        return painted.color;
    }
};

TEST(FileMaterial, EachTriangleHasItsOwn) {
    const TwoSquares two;
    const Mesh mesh = two.mesh();
    EXPECT_EQ(mesh.parts, (std::vector<std::uint16_t>{0, 0, 1, 1})); // in the order of their use
    const Aggregate aggregate = two.aggregate();
    const World world(std::span(&aggregate, 1), {});
    struct Case {
        double x, z;
        Color color;
    };
    const std::vector<Case> cases{
        {0.2, 0.2, {0.25F, 0.5F, 0.75F}}, {0.9, 0.9, {0.25F, 0.5F, 0.75F}},
        {1.25, 0.25, {0.5F, 0, 0}},       {1.75, 0.25, {0, 1, 0}}, // far side: the picture's top
        {1.25, 0.75, {0, 0, 1}},          {1.75, 0.75, {0.5F, 1, 1}},
    };
    for (const Case& c : cases)
        EXPECT_TRUE(TwoSquares::color_at(world, c.x, c.z).equalWithAbsError(c.color, 0.01F))
            << c.x << " " << c.z;
}

TEST(FileMaterial, AreRendered) {
    // Flat matte squares under an even sky of radiance 1 are as bright as their reflectance.
    test::Stage stage;
    stage.aggregates.push_back(TwoSquares().aggregate());
    stage.lights.push_back(test::even_sky(1));
    stage.camera.from = {1, 4, 0.5F};
    stage.camera.at = {1, 0, 0.5F};
    stage.camera.up = {0, 0, -1};
    stage.camera.fov = 2 * std::atan(0.5F / 4);
    stage.film.width = 16;
    stage.film.height = 8;
    stage.film.samples = 16;
    stage.film.filter = Filter::box;
    stage.film.radius = 0.5F;
    const RenderResult result = stage.render();
    const Image image = result.film.parts().front().image;
    const auto expect = [&](int x, int y, const Color& color) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(image.at(x, y)[c], color[c], 0.02) << x << " " << y << " " << c;
    };
    expect(1, 1, {0.25F, 0.5F, 0.75F});
    expect(6, 6, {0.25F, 0.5F, 0.75F});
    expect(9, 1, {0.5F, 0, 0});
    expect(14, 1, {0, 1, 0});
    expect(9, 6, {0, 0, 1});
    expect(14, 6, {0.5F, 1, 1});
}

TEST(FileMaterial, TextureTransforms) {
    // The picture's corner colours at four places, for the second square.
    struct Case {
        Json transform;
        std::array<Color, 4>
            colors; // at the near corners of its UV square: (0, 0) (1, 0) (0, 1) (1, 1)
    };
    const Color red(0.5F, 0, 0);
    const Color green(0, 1, 0);
    const Color blue(0, 0, 1);
    const Color white(0.5F, 1, 1);
    const std::vector<Case> cases{
        {Json::object(), {red, green, blue, white}},
        {{{"offset", {1, 0}}, {"scale", {-1, 1}}}, {green, red, white, blue}},
        {{{"offset", {0, 1}}, {"scale", {1, -1}}}, {blue, white, red, green}},
        {{{"scale", {0.5, 0.5}}}, {red, red, red, red}},
        // The specification's example: the lower left quadrant.
        {{{"offset", {0, 1}}, {"rotation", pi / 2}, {"scale", {0.5, 0.5}}},
         {blue, blue, blue, blue}},
        // A quarter turn: (u, v) becomes (v, 1 - u).
        {{{"offset", {0, 1}}, {"rotation", pi / 2}}, {blue, red, white, green}},
    };
    for (const Case& c : cases) {
        TwoSquares two;
        two.file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
            {"KHR_texture_transform", c.transform}};
        const Aggregate aggregate = two.aggregate();
        const World world(std::span(&aggregate, 1), {});
        for (std::size_t i = 0; i < 4; ++i) {
            const double x = i % 2 == 0 ? 1.24 : 1.76;
            const double z = i < 2 ? 0.24 : 0.76;
            EXPECT_TRUE(TwoSquares::color_at(world, x, z).equalWithAbsError(c.colors[i], 0.05F))
                << c.transform.dump() << " " << i;
        }
    }
}

TEST(FileMaterial, PicturesNeedUvs) {
    TwoSquares two;
    two.file.json["meshes"][0]["primitives"][1]["attributes"].erase("TEXCOORD_0");
    const Mesh mesh = two.mesh();
    const Asked asked;
    materials_of(asked.params, &mesh);
    EXPECT_EQ(asked.warned(), "a.lua:4: object.material: two.gltf: its pictures are not shown, "
                              "since it has no texture coordinates");
}

TEST(FileMaterial, PicturesOfOtherUvs) {
    TwoSquares two;
    Json& attributes = two.file.json["meshes"][0]["primitives"][1]["attributes"];
    attributes["TEXCOORD_1"] = two.file.floats(2, {1, 1, 1, 1, 1, 1, 1, 1});
    two.file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
    const Aggregate aggregate = two.aggregate();
    const World world(std::span(&aggregate, 1), {});
    EXPECT_TRUE(TwoSquares::color_at(world, 1.2, 0.2).equalWithAbsError({0.5F, 1, 1}, 0.01F));
}

/// The material that a glTF material becomes, and what is said of it.
struct Became {
    Material material;
    std::string warned;
};

Became became(const Json& material) {
    TwoSquares two;
    two.file.json["materials"][1] = material;
    const Mesh mesh = two.mesh();
    const Asked asked;
    return {*materials_of(asked.params, &mesh).front(), asked.warned()};
}

TEST(FileMaterial, KindsOfGltf) {
    const auto pbr = [](Json values) { return Json{{"pbrMetallicRoughness", values}}; };
    const auto plastic =
        std::get<Plastic>(became(pbr({{"metallicFactor", 0}, {"roughnessFactor", 0.4}})).material);
    EXPECT_EQ(plastic.roughness, 0.4F);
    EXPECT_EQ(plastic.ior, 1.5F);
    EXPECT_EQ(plastic.paint.texture.constant, Color(1.0F));
    const auto metal = std::get<Metal>(
        became(pbr({{"baseColorFactor", {1, 0.5, 0.25, 1}}, {"roughnessFactor", 0.1}})).material);
    EXPECT_EQ(metal.roughness, 0.1F);
    EXPECT_EQ(metal.paint.texture.constant, Color(1, 0.5F, 0.25F));
    Json clear = pbr({{"metallicFactor", 0}, {"roughnessFactor", 0}});
    clear["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                           {"KHR_materials_ior", {{"ior", 1.25}}},
                           {"KHR_materials_volume",
                            {{"attenuationColor", {1, 0.5, 0.25}}, {"attenuationDistance", 2}}}};
    const auto glass = std::get<Glass>(became(clear).material);
    EXPECT_EQ(glass.ior, 1.25F);
    EXPECT_EQ(glass.roughness, 0);
    EXPECT_NEAR(glass.absorption.x, 0, 1e-6);
    EXPECT_NEAR(glass.absorption.y, std::log(2) / 2, 1e-6);
    EXPECT_NEAR(glass.absorption.z, std::log(4) / 2, 1e-6);
}

TEST(FileMaterial, WhatIsNotHonouredIsNamed) {
    struct Case {
        Json material;
        std::string named; // "": no warning
    };
    const Json dielectric = {{"metallicFactor", 0}};
    const std::vector<Case> cases{
        {{{"name", "a"}, {"pbrMetallicRoughness", dielectric}, {"doubleSided", true}}, ""},
        {{{"name", "a"}, {"alphaMode", "OPAQUE"}}, ""},
        {{{"name", "a"}, {"alphaMode", "BLEND"}}, "alphaMode BLEND of a"},
        {{{"name", "a"}, {"alphaMode", "MASK"}, {"alphaCutoff", 0.5}}, "alphaMode MASK of a"},
        {{{"name", "a"}, {"normalTexture", {{"index", 0}}}, {"emissiveFactor", {1, 1, 1}}},
         "emissiveFactor of a, normalTexture of a"},
        {{{"name", "a"}, {"extensions", {{"KHR_materials_sheen", Json::object()}}}},
         "KHR_materials_sheen of a"},
        {{{"name", "a"}, {"pbrMetallicRoughness", {{"metallicFactor", 0.25}}}},
         "metallicFactor 0.25 of a (taken as no metal)"},
        {{{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1.5}}}},
         "roughnessFactor 1.5 of materials[1]"},
        {{{"name", "a"},
          {"pbrMetallicRoughness", dielectric},
          {"extensions", {{"KHR_materials_ior", {{"ior", 1}}}}}},
         "ior 1 of a (taken as 1.01)"},
    };
    for (const Case& c : cases)
        EXPECT_EQ(became(c.material).warned,
                  c.named.empty() ? ""
                                  : "a.lua:4: object.material: two.gltf: not honoured: " + c.named);
}

TEST(FileMaterial, ProblemsOfPictures) {
    const auto problem = [](const TwoSquares& two) {
        const Mesh mesh = two.mesh(); // no problem until somebody wants the materials
        return problem_of([&] { materials_of(Asked().params, &mesh); });
    };
    TwoSquares missing;
    missing.file.json["images"][0] = {{"uri", "wood%20grain.png"}};
    EXPECT_EQ(problem(missing), "a.lua:4: object.material: two.gltf: images[0]: there is no file "
                                "wood%20grain.png beside it");
    TwoSquares damaged;
    damaged.file.json["images"][0] = {{"uri", "data:image/png;base64,AAAA"}};
    EXPECT_EQ(problem(damaged).rfind(
                  "a.lua:4: object.material: two.gltf: images[0]: is not a PNG, JPEG", 0),
              0U)
        << problem(damaged);
}

TEST(FileMaterial, ShapesWithoutMaterials) {
    GltfBuilder file;
    file.scene({file.node({{"mesh", file.mesh(file.square())}})});
    const Mesh plain = read_mesh_bytes("plain.gltf", file.text());
    const auto problem = [](const Mesh* mesh) {
        return problem_of([&] { materials_of(Asked().params, mesh); });
    };
    EXPECT_EQ(problem(&plain), "a.lua:4: object.material: plain.gltf has no materials\n"
                               "  expected a material.*, such as material.matte {}");
    const Mesh plane = test::make_plane(1);
    EXPECT_EQ(problem(&plane),
              "a.lua:4: object.material: plane is from no file that could have materials\n"
              "  expected a material.*, or shape = mesh.file { ... }");
    EXPECT_EQ(problem(nullptr),
              "a.lua:4: object.material: the shape is from no file that could have materials\n"
              "  expected a material.*, or shape = mesh.file { ... }");
}

TEST(FileMaterial, OfObj) {
    const test::Folder folder;
    folder.write("my paints.mtl",
                 "newmtl red\nKd 1 0 0\nbump a.png\nnewmtl blue paint\nKd 0 0 1\nKs 0.2\nNs 30\n");
    // A square of red, a pentagon of blue paint, a triangle of none, another of red.
    folder.write("two.obj",
                 "mtllib my paints.mtl\nv 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nv 2 0 0\nv 2 0 1\n"
                 "f 1 2 3\nusemtl red\nf 1 2 3 4\nusemtl blue paint\nf 4 3 6 5 4\nusemtl red\n"
                 "f 1 2 3\n");
    const Mesh mesh = read_mesh(folder.file("two.obj"));
    ASSERT_EQ(mesh.triangles.size(), mesh.parts.size());
    EXPECT_EQ(mesh.parts.front(), 0); // without
    EXPECT_EQ(mesh.parts[1], 1);
    EXPECT_EQ(mesh.parts[2], 1);
    EXPECT_EQ(mesh.parts[3], 2);
    EXPECT_EQ(mesh.parts.back(), 1);
    const Asked asked;
    const Materials materials = materials_of(asked.params, &mesh);
    ASSERT_EQ(materials.size(), 3U);
    EXPECT_EQ(std::get<Matte>(*materials[0]).paint.texture.constant, Color(0.5F));
    EXPECT_EQ(std::get<Matte>(*materials[1]).paint.texture.constant, Color(1, 0, 0));
    const auto plastic = std::get<Plastic>(*materials[2]);
    EXPECT_EQ(plastic.paint.texture.constant, Color(0, 0, 1));
    EXPECT_EQ(plastic.roughness, 0.5F);
    EXPECT_EQ(asked.warned(), "a.lua:4: object.material: two.obj: not honoured: bump of red");
}

TEST(FileMaterial, AreMadeOnce) {
    const TwoSquares two;
    const Mesh mesh = two.mesh();
    EXPECT_EQ(materials_of(Asked().params, &mesh), materials_of(Asked().params, &mesh));
}

TEST(FileMaterial, TranslucencyIsOfWholeMeshes) {
    Aggregate aggregate = TwoSquares().aggregate();
    aggregate.prototypes[0].materials[1] = std::make_shared<const Material>(Translucent{});
    EXPECT_EQ(problem_of([&] { World(std::span(&aggregate, 1), {}); }),
              "two is translucent in part; a translucent material must be that of the whole mesh");
}

} // namespace
} // namespace scree
