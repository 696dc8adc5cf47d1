// SPDX-License-Identifier: GPL-3.0-or-later
// A program that is killed loses what it rendered since the last checkpoint, and no more.
#include "core/file.h"
#include "session/render_scene.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace scree {
namespace {

constexpr const char* script =
    "return scene { film = { width = 64, height = 64, samples = 2000 },\n"
    "camera = camera.perspective { from = {0, 1, 3}, at = {0, 0, 0} }, lights = { light.sky {} },\n"
    "objects = { object { shape = mesh.sphere { radius = 0.5 } } } }";

class Checkpoints : public testing::Test {
  protected:
    Checkpoints() { write_file(folder_.file("ball.lua"), script); }

    Rendered render(const RenderCare& care) const {
        SessionOptions options;
        options.path = folder_.file("ball.lua");
        Session session(options);
        const Scene scene = session.bake(session.load());
        return render_scene(session, scene, {}, care);
    }

    test::Folder folder_;
};

TEST_F(Checkpoints, AKilledRenderGoesOnToTheSamePicture) {
    RenderCare care;
    care.checkpoint = folder_.file("ball.checkpoint");
    care.checkpoint_every = 0.05;
    // Killed three times, each time after it has written a checkpoint; threads start in the child.
    for (int run = 0; run < 3; ++run) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            render(care);
            _exit(0);
        }
        const auto before = std::filesystem::exists(care.checkpoint)
                                ? std::filesystem::last_write_time(care.checkpoint)
                                : std::filesystem::file_time_type::min();
        int status = 0;
        while (!(std::filesystem::exists(care.checkpoint) &&
                 std::filesystem::last_write_time(care.checkpoint) > before) &&
               waitpid(child, &status, WNOHANG) == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
        ASSERT_TRUE(std::filesystem::exists(care.checkpoint)) << "finished before it was killed";
        care.resume = true;
    }
    const Rendered resumed = render(care);
    const Rendered whole = render({});
    EXPECT_LT(resumed.figures.stats.rays, whole.figures.stats.rays) << "it began anew";
    EXPECT_EQ(resumed.result.film.beauty().pixels, whole.result.film.beauty().pixels);
}

TEST_F(Checkpoints, AFullDiskDoesNotEndARender) {
    RenderCare care;
    care.checkpoint = folder_.file("missing/ball.checkpoint");
    care.checkpoint_every = 0.05;
    EXPECT_EQ(render(care).result.film.samples(0, 0), 2000U);
}

} // namespace
} // namespace scree
