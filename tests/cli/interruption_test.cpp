// SPDX-License-Identifier: GPL-3.0-or-later
// Signals, streams that are closed or full, limits of a file's size.
#include "tests/cli/cli_fixture.h"

#include <array>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <thread>
#include <unistd.h>

namespace scree {
namespace {

using tests::Outcome;

class InterruptionCli : public tests::CliTest {
  protected:
    InterruptionCli() {
        write_file(path("ball.lua"),
                   "return scene { film = { width = 70, height = 40, samples = 4 },\n"
                   "camera = camera.perspective { from = {0, 1, 3}, at = {0, 0, 0} },\n"
                   "lights = { light.sky {} },\n"
                   "objects = { object { shape = mesh.sphere { radius = 0.5 } } } }");
    }

    bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

    /// Runs the program until `started`, sends it the signal, and returns its exit code; -1 when it
    /// was killed by the signal.
    int interrupted(std::vector<std::string> arguments, int signal,
                    const std::function<bool()>& started) const {
        std::filesystem::remove(path("err.txt")); // of the run before
        const pid_t child = fork();
        if (child == 0) {
            if (chdir(folder_.path().c_str()) != 0)
                _exit(99);
            for (const int heeded : {SIGINT, SIGTERM, SIGHUP})
                std::signal(heeded, SIG_DFL); // whatever this test was started with
            const int err = open("err.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600);
            dup2(err, STDERR_FILENO);
            std::vector<char*> words{const_cast<char*>(SCREE_PROGRAM)};
            for (std::string& argument : arguments)
                words.push_back(argument.data());
            words.push_back(nullptr);
            execv(SCREE_PROGRAM, words.data());
            _exit(98);
        }
        int status = 0;
        while (!started()) {
            if (waitpid(child, &status, WNOHANG) != 0) {
                ADD_FAILURE() << "it ended before: " << read_file(path("err.txt"));
                return -2;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        kill(child, signal);
        waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    /// Runs a line of sh in the test's folder, in which $SCREE is the program.
    Outcome shell(const std::string& line) const {
        return run_program("/bin/sh", "-c '" + line + "'", "SCREE=" SCREE_PROGRAM);
    }

    bool has_left_overs() const {
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
            if (entry.path().filename().string().starts_with("."))
                return true;
        return false;
    }
};

TEST_F(InterruptionCli, AnInterruptedRenderKeepsTheOldPictureAndGoesOn) {
    write_file(path("a.exr"), "old");
    const std::vector<std::string> render{"render", "ball.lua", "--spp",    "16000000",
                                          "-o",     "a.exr",    "--preview"};
    // The preview shows that it renders.
    EXPECT_EQ(interrupted(render, SIGINT, [&] { return exists("a.png"); }), 130);
    EXPECT_EQ(read_file(path("a.exr")), "old");
    EXPECT_TRUE(exists("a.checkpoint"));
    EXPECT_NE(read_file(path("err.txt"))
                  .find("samples per pixel, which --resume continues; a.exr "
                        "is as it was"),
              std::string::npos)
        << read_file(path("err.txt"));
    std::filesystem::remove(path("a.png"));
    std::vector<std::string> again = render;
    again.insert(again.end(), {"--resume", "--partial"});
    EXPECT_EQ(interrupted(again, SIGTERM, [&] { return exists("a.png"); }), 143);
    EXPECT_GT(read_file(path("a.exr")).size(), 1000U);
    EXPECT_NE(read_file(path("err.txt")).find("interrupted: the picture holds what was done"),
              std::string::npos);
    EXPECT_FALSE(has_left_overs());
}

TEST_F(InterruptionCli, AScriptAndAWriteThatDoNotEndAreEnded) {
    write_file(path("loop.lua"), "print('begins') while true do end");
    const auto begins = [&] {
        return exists("err.txt") && read_file(path("err.txt")).find("begins") == 0;
    };
    EXPECT_EQ(interrupted({"check", "loop.lua"}, SIGINT, begins), 130);
    EXPECT_EQ(interrupted({"check", "loop.lua"}, SIGHUP, begins), 129);
    // Nobody reads the pipe: the program waits in a call to the system.
    ASSERT_EQ(mkfifo(path("pipe.exr").c_str(), 0600), 0);
    const auto writes = [] {
        for (const auto& entry :
             std::filesystem::directory_iterator(std::filesystem::temp_directory_path()))
            if (entry.path().filename().string().starts_with(".pipe.exr.part-"))
                return true;
        return false;
    };
    EXPECT_EQ(interrupted({"render", "ball.lua", "-o", "pipe.exr"}, SIGTERM, writes), 143);
    EXPECT_FALSE(writes());
    EXPECT_FALSE(has_left_overs());
}

TEST_F(InterruptionCli, ASignalThatIsIgnoredStaysIgnored) {
    const Outcome outcome =
        shell("trap \"\" HUP; $SCREE render ball.lua --quiet --spp 400 -o a.exr & "
              "sleep 0.2; kill -HUP $!; wait $!");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(exists("a.exr"));
}

TEST_F(InterruptionCli, MessagesThatNobodyTakesAreLost) {
    for (const char* stream : {"2>&-", "2>/dev/full", "<&- >&- 2>&-"}) {
        const Outcome outcome = shell(std::string("$SCREE render ball.lua -o a.exr ") + stream);
        EXPECT_EQ(outcome.code, 0) << stream;
        EXPECT_EQ(run("view a.exr -o b.png").code, 0) << stream;
        std::filesystem::remove(path("a.exr"));
    }
    EXPECT_EQ(shell("$SCREE check none.lua 2>&-").code, 1);
}

TEST_F(InterruptionCli, AResultThatCannotBePrintedIsAnError) {
    for (const char* command :
         {"list", "list --markdown", "check ball.lua", "--help", "--version"}) {
        const Outcome full = shell("$SCREE " + std::string(command) + " >/dev/full");
        EXPECT_EQ(full.code, 3) << command;
        EXPECT_EQ(full.err, "cannot write to stdout: No space left on device\n") << command;
        EXPECT_EQ(shell("$SCREE " + std::string(command) + " >&-").code, 3) << command;
    }
}

TEST_F(InterruptionCli, ALimitOfTheFilesSizeIsAnErrorOfWriting) {
    write_file(path("a.exr"), "old");
    const Outcome outcome = shell("ulimit -f 1; $SCREE render ball.lua --quiet -o a.exr");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.err, "cannot write a.exr: File too large\n");
    EXPECT_EQ(read_file(path("a.exr")), "old");
    EXPECT_FALSE(has_left_overs());
}

TEST_F(InterruptionCli, NamesCannotControlTheTerminal) {
    write_file(path("evil.lua"), "print('\\27[2J')\nreturn scene { name = '\\27]0;x\\7', "
                                 "['\\27[31m'] = 1 }");
    const Outcome outcome = run("check evil.lua");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ((outcome.out + outcome.err).find('\x1b'), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("\\x1b[31m"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("\\x1b[2J"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace scree
