// SPDX-License-Identifier: GPL-3.0-or-later
// Procedurals baked to textures, slices and volumes, and reading of volume files.
#include "core/file.h"
#include "core/parallel.h"
#include "core/random.h"
#include "formats/surface_texture.h"
#include "formats/texture_slices.h"
#include "formats/texture_volume.h"
#include "shapes/table.h"
#include "tests/support/disk_room.h"
#include "tests/support/pictures.h"
#include "tests/support/plugin_params.h"

#include <gtest/gtest.h>
#include <openvdb/openvdb.h>

#include <mutex>

namespace scree {
namespace {

using Vec3d = Imath::V3d;

/// A procedural whose samples contain the position and the filter of the shading point.
class Probe : public Procedural {
  public:
    void evaluate(std::span<const ShadingPoint> points,
                  std::span<ShadingSample> samples) const override {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const ShadingPoint& p = points[i];
            ShadingSample& sample = samples[i];
            sample = {};
            sample.color = Color(p.position.x, p.position.y, p.position.z);
            sample.height = p.footprint;
            sample.slope = slope;
            sample.value = p.position.y + 1;
            if (p.position.x > 0)
                sample.roughness = 0.7F;
        }
    }
    bool solid() const override { return true; }

    Vec3 slope{0.0F, 0.0F, 0.0F};
};

std::shared_ptr<const Mesh> component(const std::string& name,
                                      const std::map<std::string, Value>& values = {}) {
    return std::make_shared<const Mesh>(tests::make(component_table(), name, values));
}

TextureSource source_of(std::shared_ptr<const Mesh> mesh, const Probe& probe = {}) {
    return {.mesh = std::move(mesh),
            .procedural = std::make_shared<const Probe>(probe),
            .random = 0.5F,
            .roughness = 0.2F};
}

TEST(SurfaceTexture, HoldsTheValuesOfTheSurface) {
    const TextureSource source = source_of(component("sphere", {{"radius", 2.0}}));
    const UvRaster raster(*source.mesh, 128, 64);
    const Image image = surface_texture(source, raster, TextureChannel::color, {});
    for (int y = 2; y < 62; ++y)
        for (int x = 0; x < 128; ++x) {
            const float* p = image.at(x, y);
            EXPECT_NEAR(Vec3(p[0], p[1] - 2, p[2]).length(), 2, 0.02); // it stands on y = 0
            const Vec2 uv((x + 0.5) / 128, 1 - (y + 0.5) / 64);
            const Vec3d sphere(std::sin(pi * uv.y) * std::cos(2 * pi * uv.x), -std::cos(pi * uv.y),
                               std::sin(pi * uv.y) * std::sin(2 * pi * uv.x));
            EXPECT_NEAR(p[1], 2 + 2 * sphere.y, 0.01);
            EXPECT_NEAR(std::abs(p[2]), 2 * std::abs(sphere.z), 0.01);
        }
    // At the equator a texel is 4 pi / 128 wide and 2 pi / 64 high: a square.
    const Image footprints = surface_texture(source, raster, TextureChannel::height, {});
    EXPECT_NEAR(*footprints.at(40, 32), 4 * pi / 128, 2e-3);
    EXPECT_LT(*footprints.at(40, 5), 0.5 * 4 * pi / 128) << "narrow towards the pole";
}

TEST(SurfaceTexture, RoughnessIsThatOfTheMaterialIfNoneIsGiven) {
    const TextureSource source = source_of(component("sphere"));
    const UvRaster raster(*source.mesh, 64, 64);
    const Image where = surface_texture(source, raster, TextureChannel::color, {});
    const Image image = surface_texture(source, raster, TextureChannel::roughness, {});
    for (int x = 0; x < 64; ++x)
        EXPECT_EQ(*image.at(x, 30), *where.at(x, 30) > 0 ? 0.7F : 0.2F);
}

// In the x-z plane u is +x and v is -z. Heights that rise along +x tilt normals towards -u; green
// of the OpenGL convention points along +v.
TEST(SurfaceTexture, NormalsLeanAwayFromTheSlope) {
    Probe probe;
    const auto normal = [&](const Vec3& slope) {
        probe.slope = slope;
        const TextureSource source = source_of(component("plane"), probe);
        const UvRaster raster(*source.mesh, 8, 8);
        const Image image = surface_texture(source, raster, TextureChannel::normal, {});
        const float* p = image.at(3, 4);
        return Vec3(p[0], p[1], p[2]) * 2.0F - Vec3(1.0F);
    };
    const float half = std::sqrt(0.5F);
    EXPECT_LT((normal(Vec3(0, 0, 0)) - Vec3(0, 0, 1)).length(), 1e-5F);
    EXPECT_LT((normal(Vec3(1, 0, 0)) - Vec3(-half, 0, half)).length(), 1e-5F);
    EXPECT_LT((normal(Vec3(0, 0, -1)) - Vec3(0, -half, half)).length(), 1e-5F);
    EXPECT_LT((normal(Vec3(0, 5, 0)) - Vec3(0, 0, 1)).length(), 1e-5F) << "along the normal";
}

TEST(TextureSlices, LieInTheMiddlesOfSlabs) {
    const auto mesh = component("box", {{"width", 0.4}, {"height", 0.2}, {"depth", 0.1}});
    struct Case {
        int axis, width, height;
        Vec3 right, up;
    };
    for (const auto& [axis, width, height, right, up] :
         {Case{0, 20, 40, {0, 0, -1}, {0, 1, 0}}, Case{1, 40, 10, {1, 0, 0}, {0, 0, -1}},
          Case{2, 40, 20, {1, 0, 0}, {0, 1, 0}}}) {
        const SliceStack stack = slices_through(*mesh, axis, 5, 40, 0);
        EXPECT_EQ(stack.width, width);
        EXPECT_EQ(stack.height, height);
        EXPECT_GT((right % up)[axis], 0) << "seen from the axis's positive side";
        const std::vector<Image> images =
            slice_images(source_of(mesh), stack, TextureChannel::color, {}, {});
        ASSERT_EQ(images.size(), 5U);
        const Vec3 size = bounds(*mesh).size();
        for (int i = 0; i < 5; ++i) {
            const Image& image = images[std::size_t(i)];
            const auto at = [&](int x, int y) {
                return Vec3(image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2]);
            };
            const Vec3 first = at(0, 0), last = at(width - 1, height - 1);
            EXPECT_NEAR(first[axis] - bounds(*mesh).min[axis], size[axis] * (float(i) + 0.5F) / 5,
                        1e-6);
            EXPECT_NEAR(stack.position(i), first[axis], 1e-6);
            const float pixel = std::abs(right.dot(size)) / float(width);
            EXPECT_NEAR((last - first).dot(right), pixel * float(width - 1), 1e-6);
            EXPECT_NEAR((first - last).dot(up), pixel * float(height - 1), 1e-6);
        }
    }
    const SliceStack stack = slices_through(*mesh, 2, 12, 8, 30);
    EXPECT_EQ(stack.width, 8);
    EXPECT_EQ(stack.height, 30);
    EXPECT_EQ(slice_name(stack, 0), "slice_01_z_-0.045833");
    Mesh line;
    line.positions = {Vec3(0, 0, 0), Vec3(0, 1, 0)};
    EXPECT_THROW(slices_through(line, 1, 4, 16, 0), Error);
    EXPECT_EQ(slices_through(line, 0, 4, 16, 0).width, 1);
}

TEST(TextureSlices, AreCombinedOnAContactSheet) {
    std::vector<Image> slices(5, Image(6, 4, {"Y"}));
    for (std::size_t i = 0; i < slices.size(); ++i)
        std::fill(slices[i].pixels.begin(), slices[i].pixels.end(), 0.1F * float(i));
    const Image sheet = contact_sheet(slices);
    EXPECT_EQ(sheet.width, 2 * 6 + 4);
    EXPECT_EQ(sheet.height, 3 * 4 + 2 * 4);
    EXPECT_EQ(*sheet.at(0, 0), 0);
    EXPECT_FLOAT_EQ(*sheet.at(15, 0), 0.1F);
    EXPECT_FLOAT_EQ(*sheet.at(5, 19), 0.4F);
    EXPECT_EQ(*sheet.at(7, 0), 1) << "a gap";
    EXPECT_EQ(*sheet.at(15, 19), 1) << "no slice";
}

struct ReadVolume {
    openvdb::FloatGrid::Ptr density;
    openvdb::Vec3SGrid::Ptr color;
    std::string scene;
};

ReadVolume read_volume(const std::string& path) {
    openvdb::initialize();
    openvdb::io::File file(path);
    file.open(false);
    ReadVolume out{openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("density")),
                   openvdb::gridPtrCast<openvdb::Vec3SGrid>(file.readGrid("color")),
                   file.getMetadata()->metaValue<std::string>("scree:scene")};
    file.close();
    return out;
}

TEST(TextureVolume, ReadsBackInPlace) {
    const test::Folder folder;
    const std::string path = folder.file("sphere.vdb");
    const TextureSource source = source_of(component("sphere"));
    const TextureVolume volume = texture_volume(*source.mesh, 20);
    ASSERT_FALSE(volume.inside.empty());
    Matrix turn, move;
    turn.setAxisAngle(Vec3(1, 0, 0), 0.7F);
    move.setTranslation(Vec3(3, -2, 5));
    const WideMatrix world_from_object(turn * move);
    volume_file(source, volume, world_from_object, {})->write(path, {{"scree:scene", "s.lua"}});

    const ReadVolume read = read_volume(path);
    EXPECT_EQ(read.scene, "s.lua");
    EXPECT_EQ(read.density->getGridClass(), openvdb::GRID_FOG_VOLUME);
    std::size_t held = 0;
    for (const std::uint8_t v : volume.inside)
        held += v;
    EXPECT_EQ(read.density->activeVoxelCount(), held);
    EXPECT_EQ(read.color->activeVoxelCount(), held);
    const VoxelGrid& grid = volume.grid;
    for (int k = 0; k < grid.count[2]; ++k)
        for (int j = 0; j < grid.count[1]; ++j)
            for (int i = 0; i < grid.count[0]; ++i) {
                const openvdb::Coord at(i, j, k);
                const bool inside = volume.inside[grid.index(i, j, k)] != 0;
                ASSERT_EQ(read.density->tree().isValueOn(at), inside);
                const Vec3d here = grid.centre(i, j, k);
                const openvdb::Vec3s color = read.color->tree().getValue(at);
                ASSERT_NEAR(read.density->tree().getValue(at), inside ? here.y + 1 : 0, 1e-6);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(color[c], inside ? here[c] : 0, 1e-6);
                const openvdb::Vec3d world = read.density->indexToWorld(at);
                const Vec3d expected = here * world_from_object;
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(world[c], expected[c], 1e-6);
            }
}

TEST(TextureVolume, FillsTheBoxOfAnOpenMesh) {
    const TextureSource source = source_of(component("plane"));
    const TextureVolume volume = texture_volume(*source.mesh, 6);
    EXPECT_TRUE(volume.inside.empty());
    const std::vector<Image> images = volume_images(source, volume, 1, TextureChannel::value, {});
    ASSERT_EQ(images.size(), 1U);
    EXPECT_EQ(images[0].channels, std::vector<std::string>{"Y"});
    EXPECT_EQ(images[0].pixels, std::vector<float>(36, 1.0F));
}

TEST(TextureVolume, PicturesHaveAnAlphaOfTheInside) {
    const TextureSource source = source_of(component("sphere"));
    const TextureVolume volume = texture_volume(*source.mesh, 16);
    for (int axis = 0; axis < 3; ++axis) {
        const SliceStack stack = slices_of(volume.grid, axis);
        const std::vector<Image> images =
            volume_images(source, volume, axis, TextureChannel::color, {});
        ASSERT_EQ(images.size(), 16U);
        for (int i = 0; i < 16; ++i)
            for (int y = 0; y < 16; ++y)
                for (int x = 0; x < 16; ++x) {
                    const float* pixel = images[std::size_t(i)].at(x, y);
                    const Vec3d here = stack.centre(x, y, i);
                    const Vec3d cell = (here - volume.grid.corner) / volume.grid.side;
                    const bool inside =
                        volume.inside[volume.grid.index(int(cell.x), int(cell.y), int(cell.z))] !=
                        0;
                    ASSERT_EQ(pixel[3], inside ? 1 : 0);
                    for (int c = 0; c < 3; ++c)
                        ASSERT_NEAR(pixel[c], inside ? here[c] : 0, 1e-6);
                }
    }
}

TEST(TextureVolume, SameBytesOnAnyThreads) {
    const test::Folder folder;
    const TextureSource source = source_of(component("torus"));
    const auto bytes = [&](int threads, const std::string& scene) {
        const ThreadLimit limit(threads);
        const std::string path = folder.file("a.vdb");
        volume_file(source, texture_volume(*source.mesh, 24), WideMatrix(), {})
            ->write(path, {{"scree:scene", scene}});
        return read_file(path);
    };
    EXPECT_EQ(bytes(1, "a"), bytes(2, "a"));
    EXPECT_NE(bytes(1, "a"), bytes(1, "b"));
}

TEST(TextureVolume, AFullDiskLeavesTheOldFileIntact) {
    const test::Folder folder;
    const std::string path = folder.file("full.vdb");
    const TextureSource source = source_of(component("sphere"));
    const auto file = volume_file(source, texture_volume(*source.mesh, 30), WideMatrix(), {});
    write_file(path, "old");
    for (const rlim_t room : {0U, 100U, 20000U}) {
        Fault fault = Fault::usage;
        {
            const tests::DiskRoom limit(room);
            try {
                file->write(path, {});
            } catch (const Error& error) {
                fault = error.fault();
            }
        }
        EXPECT_EQ(fault, Fault::resource) << room;
        EXPECT_EQ(read_file(path), "old") << room;
    }
    EXPECT_EQ(
        std::distance(
            std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()), {}),
        1)
        << "nothing is left behind";
    file->write(path, {});
    EXPECT_GT(read_file(path).size(), 20000U);
    EXPECT_THROW(file->write("/no/such/folder/a.vdb", {}), Error);
}

} // namespace
} // namespace scree
