// SPDX-License-Identifier: GPL-3.0-or-later
// Uses the examples of docs/architecture.md: adds them to a catalog and tables at run time.
#include "core/file.h"
#include "formats/table.h"
#include "model/generator.h"
#include "model/procedural.h"
#include "model/table.h"
#include "render/render.h"
#include "scenes/reader/scene.h"
#include "session/catalog.h"
#include "session/export_scene.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree {

Plugin<Generator> line_plugin();
Plugin<MakeProcedural> layers_plugin();
Plugin<MakeMaterial> dust_plugin();
SceneFormat csv_format();

namespace {

/// A scene with the generator and the procedural of the examples.
const char* const script = R"(
local stripes = material.matte { color = procedural.layers { thickness = 0.02 } }
return scene { objects = {
  generator.line { shape = mesh.box { width = 0.05 }, step = 0.2, count = 4 },
  object { shape = mesh.sphere {}, material = stripes },
  object { shape = mesh.plane { size = 1 }, material = material.dust { color = { 0.5, 1, 0 } } } } }
)";

/// Returns what `use` returns for a session with the examples and its scene.
template <typename Use>
auto with_baked(Use use) {
    Catalog catalog = standard_catalog();
    Registry<Generator> generators("generator");
    generators.add(line_plugin());
    catalog.add(generator_items(generators));
    Registry<MakeProcedural> procedurals("procedural");
    procedurals.add(layers_plugin());
    catalog.add(procedurals);
    Registry<MakeMaterial> materials("material");
    materials.add(dust_plugin());
    catalog.add(materials);

    const test::Folder folder;
    Session session({.path = folder.write("scene.lua", script)}, catalog);
    return use(session, session.bake(session.load()));
}

Scene baked() {
    return with_baked([](Session& /*session*/, Scene scene) { return scene; });
}

TEST(Examples, TheGeneratorPlacesItsCopies) {
    const Scene scene = baked();
    ASSERT_EQ(scene.aggregates.size(), 3U);
    const Aggregate& line = scene.aggregates.front();
    ASSERT_EQ(line.instances.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(line.instances[i].world_from_object[3][0], 0.2 * double(i), 1e-6);
}

TEST(Examples, TheProceduralIsFilteredOverThePixel) {
    const Scene scene = baked();
    const Material& material = *scene.aggregates[1].prototypes[0].materials.front();
    const Procedural& layers = *paint_of(material)->texture.procedural;
    EXPECT_TRUE(layers.solid());
    ShadingPoint point;
    point.position = {0, 0.005F, 0};
    ShadingSample sharp;
    layers.evaluate({&point, 1}, {&sharp, 1});
    EXPECT_NEAR(sharp.value, 1, 1e-4);
    point.footprint = 1;
    ShadingSample blurred;
    layers.evaluate({&point, 1}, {&blurred, 1});
    EXPECT_NEAR(blurred.value, 0.5, 1e-4);
}

// Of light from all sides a surface of white grains, seen from straight above, gives back
// (1 - ln 2) / 2: the integral of the BRDF times the cosine.
TEST(Examples, TheMaterialScattersAsItsFormulaSays) {
    const Scene scene = baked();
    const std::vector<Light> lights{Sky{}};
    const World world({&scene.aggregates[2], 1}, lights);
    const Camera camera{.from = {0, 1, 0}, .at = WideVec3(0), .up = {0, 0, 1}, .fov = 0.01F};
    const FilmSettings film{.width = 8, .height = 8, .samples = 256, .depth = 2};
    const Image picture = render(world, camera, film, {}).film.beauty();
    Imath::V3d mean(0);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (int c = 0; c < 3; ++c)
                mean[c] += double(picture.at(x, y)[c]) / 64;
    const double white = (1 - std::log(2)) / 2;
    EXPECT_NEAR(mean.x, 0.5 * white, 0.001);
    EXPECT_NEAR(mean.y, white, 0.002);
    EXPECT_EQ(mean.z, 0);
}

TEST(Examples, TheFormatWritesWhatWasGenerated) {
    const test::Folder folder;
    const std::string path = folder.file("bake.csv");
    with_baked([&](Session& session, Scene scene) {
        const std::vector<SceneFormat> formats{csv_format()};
        const SceneFormat& format = scene_format(formats, path);
        export_scene(session, std::move(scene), format, path, {}, {});
    });
    EXPECT_EQ(read_file(path), "name,x,y,z\n"
                               "copy,0,0,0\n"
                               "copy,0.2,0,0\n"
                               "copy,0.4,0,0\n"
                               "copy,0.6,0,0\n");
}

} // namespace
} // namespace scree
