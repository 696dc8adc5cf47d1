// SPDX-License-Identifier: GPL-3.0-or-later
// The union of solids against closed forms, the selection of parts, and the files written.
#include "core/error.h"
#include "core/file.h"
#include "core/parallel.h"
#include "fabrication/fabricate.h"
#include "formats/read_mesh.h"
#include "formats/write_3mf.h"
#include "formats/write_stl.h"
#include "tests/support/fabrication_parts.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <Model/COM/NMR_DLLInterfaces.h>

namespace scree {
namespace {

using tests::aggregate_of;
using tests::ball;
using tests::closed_room;
using tests::component;
using tests::instance;
using tests::placed;

constexpr double mm = 1e-3, mm3 = 1e-9;

Fabrication made_of(const Aggregate& aggregate, const FabricationOptions& options) {
    return fabricate({&aggregate, 1}, options, {});
}

Aggregate two_balls(float distance) {
    return aggregate_of({ball()},
                        {instance(0, placed({0, 0, 0})), instance(0, placed({distance, 0, 0}))});
}

Aggregate two_boxes(float gap) {
    return aggregate_of({component("box", {{"width", 0.01}, {"height", 0.01}, {"depth", 0.01}})},
                        {instance(0, placed({0, 0, 0})), instance(0, placed({0.01F + gap, 0, 0}))});
}

std::string message_of(const Aggregate& aggregate, const FabricationOptions& options) {
    try {
        made_of(aggregate, options);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Fabrication, VolumeOfOverlappingBallsIsThatOfTheirUnion) {
    FabricationOptions options;
    options.resolution = 0.5 * mm;
    for (const double distance : {0.006, 0.012, 0.018}) {
        const double r = 0.01, h = 2 * r - distance; // half height of their common lens
        const double lens = pi * h * h * (distance * distance + 4 * distance * r) / (12 * distance);
        const double expected = 2 * (4.0 / 3) * pi * r * r * r - lens;
        const Fabrication made = made_of(two_balls(float(distance)), options);
        ASSERT_EQ(made.parts.size(), 1U);
        EXPECT_NEAR(made.parts[0].volume, expected, 0.01 * expected);
        EXPECT_NEAR(volume(made.mesh), made.parts[0].volume, 1e-5 * expected);
        EXPECT_TRUE(inspect(made.mesh).closed());
    }
}

TEST(Fabrication, PartsApartAreRemovedOrKept) {
    Aggregate aggregate = two_balls(0.03F);
    aggregate.instances[1].world_from_object = WideMatrix(placed({0.03F, 0, 0}, Vec3(0.0F), 0.5F));
    FabricationOptions options;
    options.resolution = 0.5 * mm;
    const double large = 4.0 / 3 * pi * 1e-6;
    const Fabrication one = made_of(aggregate, options);
    ASSERT_EQ(one.parts.size(), 1U);
    ASSERT_EQ(one.removed.size(), 1U);
    EXPECT_NEAR(one.parts[0].volume, large, 0.01 * large);
    EXPECT_NEAR(one.removed[0].volume, large / 8, 0.01 * large / 8);
    EXPECT_NEAR(volume(one.mesh), large, 0.01 * large);
    options.keep_parts = true;
    const Fabrication both = made_of(aggregate, options);
    EXPECT_EQ(both.parts.size(), 2U);
    EXPECT_TRUE(both.removed.empty());
    EXPECT_NEAR(volume(both.mesh), large * 9 / 8, 0.01 * large);
}

// A ball of radius R resting on the edges of both boxes extends R - sqrt(R^2 - (gap/2)^2) into the
// gap; the closing fills the rest.
TEST(Fabrication, ABridgeFillsNarrowGapsOnly) {
    FabricationOptions options;
    options.resolution = 0.5 * mm;
    EXPECT_EQ(made_of(two_boxes(0.002F), options).removed.size(), 1U);
    options.bridge = 0.9 * mm;
    EXPECT_EQ(made_of(two_boxes(0.002F), options).removed.size(), 1U);
    options.bridge = 2 * mm;
    const Fabrication made = made_of(two_boxes(0.002F), options);
    EXPECT_TRUE(made.removed.empty());
    const double reach = 2 - std::sqrt(4.0 - 1) + 0.25; // plus half a cell
    const double most = 2000 + 2 * 10 * 10, least = 2000 + 2 * (10 - 2 * reach) * (10 - 2 * reach);
    EXPECT_GT(made.parts[0].volume, 0.99 * least * mm3);
    EXPECT_LT(made.parts[0].volume, 1.01 * most * mm3);
    // The closing of a convex body is the body.
    options.resolution = 1 * mm;
    const Aggregate alone = aggregate_of({ball()}, {instance(0, placed({0, 0, 0}))});
    const double sphere = 4.0 / 3 * pi * 1e-6;
    EXPECT_NEAR(made_of(alone, options).parts[0].volume, sphere, 0.02 * sphere);
}

TEST(Fabrication, EnclosedVoidsAreFilledOrKept) {
    FabricationOptions options;
    options.resolution = 0.25 * mm;
    const Fabrication filled = made_of(closed_room(), options);
    EXPECT_EQ(filled.voids, 1U);
    EXPECT_TRUE(filled.removed.empty()); // the ball lies in the filled void
    EXPECT_NEAR(filled.void_volume, 4096 * mm3, 0.02 * 4096 * mm3);
    EXPECT_NEAR(volume(filled.mesh), 8000 * mm3, 0.01 * 8000 * mm3);
    options.keep_voids = true;
    const Fabrication kept = made_of(closed_room(), options);
    EXPECT_EQ(kept.voids, 1U);
    ASSERT_EQ(kept.removed.size(), 1U);
    const double inner = 4.0 / 3 * pi * 64;
    EXPECT_NEAR(kept.removed[0].volume, inner * mm3, 0.02 * inner * mm3);
    EXPECT_NEAR(volume(kept.mesh), (8000 - 4096) * mm3, 0.02 * 3904 * mm3);
}

class FabricationFile : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder.file(name); }
    Mesh solid(int threads = 0) {
        const ThreadLimit limit(threads);
        FabricationOptions options;
        options.bridge = 1 * mm;
        options.resolution = 0.5 * mm;
        return made_of(two_balls(0.012F), options).mesh;
    }
    test::Folder folder;
};

TEST_F(FabricationFile, StlReadsBackInMillimetresWithZUp) {
    const Mesh mesh = solid();
    write_stl(path("a.stl"), mesh);
    const Mesh read = to_mesh(read_stl(read_file(path("a.stl"))));
    EXPECT_EQ(read.triangles.size(), mesh.triangles.size());
    EXPECT_TRUE(inspect(read).closed());
    EXPECT_NEAR(volume(read), volume(mesh) / mm3, 1e-5 * volume(mesh) / mm3);
    const Box3 box = bounds(read), from = bounds(mesh);
    EXPECT_NEAR(box.max.x, from.max.x * 1000, 1e-4);
    EXPECT_NEAR(box.max.z, from.max.y * 1000, 1e-4);
    EXPECT_NEAR(box.max.y, from.min.z * -1000, 1e-4);
}

// The mesh of the first object of a 3MF file.
Mesh read_3mf(const std::string& path) {
    NMR::PLib3MFModel* model = nullptr;
    NMR::PLib3MFModelReader* reader = nullptr;
    NMR::PLib3MFModelResourceIterator* objects = nullptr;
    NMR::PLib3MFModelMeshObject* object = nullptr;
    BOOL found = 0;
    EXPECT_EQ(NMR::lib3mf_createmodel(&model), 0);
    EXPECT_EQ(NMR::lib3mf_model_queryreader(model, "3mf", &reader), 0);
    EXPECT_EQ(NMR::lib3mf_reader_readfromfileutf8(reader, path.c_str()), 0);
    EXPECT_EQ(NMR::lib3mf_model_getmeshobjects(model, &objects), 0);
    EXPECT_EQ(NMR::lib3mf_resourceiterator_movenext(objects, &found), 0);
    EXPECT_EQ(NMR::lib3mf_resourceiterator_getcurrent(objects, &object), 0);
    DWORD vertices = 0, triangles = 0, unit = 0;
    EXPECT_EQ(NMR::lib3mf_model_getunit(model, &unit), 0);
    EXPECT_EQ(unit, DWORD(NMR::MODELUNIT_MILLIMETER));
    EXPECT_EQ(NMR::lib3mf_meshobject_getvertexcount(object, &vertices), 0);
    EXPECT_EQ(NMR::lib3mf_meshobject_gettrianglecount(object, &triangles), 0);
    Mesh mesh;
    for (DWORD v = 0; v < vertices; ++v) {
        NMR::MODELMESHVERTEX at;
        EXPECT_EQ(NMR::lib3mf_meshobject_getvertex(object, v, &at), 0);
        mesh.positions.emplace_back(at.m_fPosition[0], at.m_fPosition[1], at.m_fPosition[2]);
    }
    for (DWORD t = 0; t < triangles; ++t) {
        NMR::MODELMESHTRIANGLE at;
        EXPECT_EQ(NMR::lib3mf_meshobject_gettriangle(object, t, &at), 0);
        mesh.triangles.push_back({at.m_nIndices[0], at.m_nIndices[1], at.m_nIndices[2]});
    }
    for (NMR::PLib3MFBase* handle : {object, objects, reader, model})
        NMR::lib3mf_release(handle);
    return mesh;
}

TEST_F(FabricationFile, ThreeMfReadsBackInMillimetres) {
    const Mesh mesh = solid();
    write_3mf(path("a.3mf"), mesh, "two balls");
    const Mesh read = read_3mf(path("a.3mf"));
    EXPECT_EQ(read.triangles, mesh.triangles);
    EXPECT_NEAR(volume(read), volume(mesh) / mm3, 1e-5 * volume(mesh) / mm3);
}

TEST_F(FabricationFile, SameBytesOnAnyThreads) {
    const Mesh one = solid(1), four = solid(4);
    write_stl(path("one.stl"), one);
    write_stl(path("four.stl"), four);
    EXPECT_TRUE(read_file(path("one.stl")) == read_file(path("four.stl")));
    write_3mf(path("one.3mf"), one, "balls");
    write_3mf(path("four.3mf"), four, "balls");
    EXPECT_TRUE(read_file(path("one.3mf")) == read_file(path("four.3mf")));
}

TEST(Fabrication, OpenComponentsAreNamedAndLeftOut) {
    Aggregate aggregate = two_balls(0.012F);
    aggregate.prototypes.push_back(component("plane", {}));
    aggregate.instances.push_back(instance(1, placed({0, 0, 0})));
    aggregate.prototypes.push_back({.name = "hair", .shape = std::make_shared<Strands>()});
    aggregate.instances.push_back(instance(2, placed({0, 0, 0})));
    const std::vector<OpenComponent> open = open_components({&aggregate, 1});
    ASSERT_EQ(open.size(), 2U);
    EXPECT_EQ(open[0].name, "plane");
    EXPECT_GT(open[0].facts.boundary_edges, 0U);
    EXPECT_FALSE(open[0].has_strands);
    EXPECT_EQ(open[1].name, "hair");
    EXPECT_TRUE(open[1].has_strands);
    FabricationOptions options;
    options.resolution = 0.5 * mm;
    EXPECT_EQ(made_of(aggregate, options).solids, 2U);
}

TEST(Fabrication, MessagesNameInvalidOptions) {
    FabricationOptions options;
    options.resolution = 1e-7;
    EXPECT_EQ(message_of(two_balls(0.012F), options),
              "a resolution of 0.0001 mm is too fine for a scene that reaches 22 mm from its "
              "origin; expected at least 0.0007333 mm");
    options.resolution = 0.1;
    EXPECT_EQ(message_of(two_balls(0.012F), options),
              "nothing is left at a resolution of 100 mm: the components are thinner");
    options.resolution = 0.5 * mm;
    options.bridge = 0.01;
    EXPECT_EQ(message_of(two_balls(0.012F), options),
              "a bridge of 10 mm is too wide for a resolution of 0.5 mm; expected at most 16 "
              "times it");
    options.bridge = 0;
    options.memory = 1 << 20;
    EXPECT_EQ(message_of(two_balls(0.012F), options),
              "a solid at a resolution of 0.5 mm needs more than the 0.0 GiB of memory that are "
              "available\n  expected a coarser one, such as 1 mm");
    EXPECT_EQ(message_of(aggregate_of({}, {}), {}),
              "there is no closed component to make a solid of");
}

} // namespace
} // namespace scree
