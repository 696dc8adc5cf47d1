// SPDX-License-Identifier: GPL-3.0-or-later
// A picture does not depend on how its making is cut into steps, runs and shards.
#include "core/error.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace scree {
namespace {

using test::Stage;

Stage ball_stage(int samples, float grey = 0.5F) {
    Stage stage;
    stage.film.width = 70; // five tiles wide, the last one narrow
    stage.film.height = 40;
    stage.film.samples = samples;
    stage.film.depth = 6;
    stage.camera.from = {0.0F, 1.0F, 3.0F};
    stage.camera.fov = 0.7F;
    stage.lights.push_back(test::even_sky(1));
    stage.add(test::make_sphere(0.6F, 12, false), test::grey_matte(grey));
    stage.add(test::make_plane(4), test::grey_matte(grey), test::move(Vec3(0.0F, -0.6F, 0.0F)));
    return stage;
}

void expect_same(const Film& a, const Film& b) {
    const std::vector<ImagePart> parts_a = a.parts();
    const std::vector<ImagePart> parts_b = b.parts();
    for (std::size_t i = 0; i < parts_a.size(); ++i)
        EXPECT_EQ(parts_a[i].image.pixels, parts_b[i].image.pixels) << parts_a[i].name;
}

// Every run renders a little and is saved, and another continues.
Film in_runs(const Stage& stage, const World& world, const RenderOptions& options, double seconds) {
    std::string state;
    for (int run = 0; run < 100000; ++run) {
        Rendering rendering(world, stage.camera, stage.film, options);
        if (!state.empty()) {
            std::istringstream in(state);
            rendering.restore(in);
        }
        rendering.step(seconds);
        if (rendering.finished())
            return rendering.take_film();
        std::ostringstream out;
        rendering.save(out);
        state = out.str();
    }
    ADD_FAILURE() << "never finished";
    return {1, 1};
}

TEST(Resume, ManyRunsGiveThePixelsOfOne) {
    const Stage stage = ball_stage(80);
    const World world(stage.aggregates, stage.lights);
    for (const double noise : {0.0, 0.03}) {
        RenderOptions options;
        options.noise = noise;
        const Film whole = render(world, stage.camera, stage.film, options).film;
        options.threads = 1; // so that every run is interrupted within a tile
        expect_same(in_runs(stage, world, options, 0.001), whole);
    }
}

TEST(Resume, GoesOnForMoreSamples) {
    Stage stage = ball_stage(24);
    const World world(stage.aggregates, stage.lights);
    Rendering few(world, stage.camera, stage.film, {});
    few.step(1000);
    ASSERT_TRUE(few.finished());
    std::stringstream state;
    few.save(state);
    stage.film.samples = 60;
    Rendering more(world, stage.camera, stage.film, {});
    more.restore(state);
    EXPECT_FALSE(more.finished());
    EXPECT_EQ(more.samples(), 24);
    more.step(1000);
    expect_same(more.film(), render(world, stage.camera, stage.film, {}).film);
    EXPECT_EQ(more.stats().samples_per_pixel, 60);
}

TEST(Resume, RefusesAnotherSceneAndACutFile) {
    const Stage stage = ball_stage(8);
    const World world(stage.aggregates, stage.lights);
    Rendering rendering(world, stage.camera, stage.film, {});
    rendering.pass();
    std::ostringstream out;
    rendering.save(out);
    const std::string state = out.str();

    const Stage darker = ball_stage(8, 0.499F);
    const World other(darker.aggregates, darker.lights);
    Rendering elsewhere(other, darker.camera, darker.film, {});
    std::istringstream whole(state);
    EXPECT_THROW(elsewhere.restore(whole), Error);
    EXPECT_EQ(elsewhere.samples(), 0);
    elsewhere.step(1000);
    expect_same(elsewhere.film(), darker.render().film);

    for (const std::size_t length : {std::size_t{0}, std::size_t{100}, state.size() - 1}) {
        std::istringstream cut(state.substr(0, length));
        EXPECT_THROW(rendering.restore(cut), Error) << length;
    }
    std::istringstream longer(state + "x");
    EXPECT_THROW(rendering.restore(longer), Error);
    EXPECT_EQ(rendering.samples(), 1);
}

TEST(Shards, ShareAllPixelsEvenly) {
    for (const auto& [width, height] : {std::pair{70, 40}, {1, 1}, {1280, 720}, {33, 500}})
        for (const int count : {1, 3, 16, 100}) {
            std::vector<int> owners(std::size_t(width) * std::size_t(height));
            std::size_t fewest = owners.size();
            std::size_t most = 0;
            for (int index = 0; index < count; ++index) {
                const std::vector<Tile> tiles = shard_tiles(width, height, {index, count});
                fewest = std::min(fewest, tiles.size());
                most = std::max(most, tiles.size());
                for (const Tile& tile : tiles)
                    for (int y = tile.y0; y < tile.y1; ++y)
                        for (int x = tile.x0; x < tile.x1; ++x)
                            ++owners[std::size_t(y * width + x)];
            }
            EXPECT_EQ(std::ranges::count(owners, 1), std::ssize(owners));
            EXPECT_LE(most - fewest, 1U);
        }
}

TEST(Shards, HaveThePixelsOfTheWhole) {
    const Stage stage = ball_stage(16);
    const World world(stage.aggregates, stage.lights);
    const Image whole = render(world, stage.camera, stage.film, {}).film.beauty();
    for (const int count : {3, 16}) {
        std::size_t compared = 0;
        for (int index = 0; index < count; ++index) {
            RenderOptions options;
            options.shard = {index, count};
            const RenderResult result = render(world, stage.camera, stage.film, options);
            if (!shard_tiles(70, 40, options.shard).empty()) {
                EXPECT_EQ(result.stats.samples_per_pixel, 16);
            }
            const Image part = result.film.beauty();
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 70; ++x) {
                    if (result.film.samples(x, y) == 0)
                        continue;
                    ++compared;
                    EXPECT_TRUE(std::equal(part.at(x, y), part.at(x, y) + 4, whole.at(x, y)));
                }
        }
        EXPECT_EQ(compared, 70U * 40U);
    }
}

} // namespace
} // namespace scree
