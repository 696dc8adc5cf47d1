// SPDX-License-Identifier: GPL-3.0-or-later
// What is written where something is already: a link, a pipe, a device, what a killed program left.
#include "core/file.h"
#include "core/temporary_file.h"
#include "tests/support/errors.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <future>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace scree {
namespace {

namespace fs = std::filesystem;
using tests::error_of;

class FileWriteTest : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.file(name); }
    std::ptrdiff_t files() const {
        return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
    }

    test::Folder folder_;
};

std::string content(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(FileWriteTest, GoesWhereALinkLeadsAndKeepsTheLink) {
    fs::create_directory(path("far"));
    write_file(path("far/target.txt"), "old");
    fs::create_symlink("far/target.txt", path("link.txt"));
    fs::create_symlink("link.txt", path("link_to_link.txt"));
    write_file(path("link_to_link.txt"), "new");
    EXPECT_EQ(content(path("far/target.txt")), "new");
    EXPECT_TRUE(fs::is_symlink(path("link.txt")));
    EXPECT_TRUE(fs::is_symlink(path("link_to_link.txt")));

    fs::create_symlink("far/none_yet.txt", path("dangling.txt"));
    write_file(path("dangling.txt"), "made");
    EXPECT_EQ(content(path("far/none_yet.txt")), "made");

    fs::create_symlink("b.txt", path("a.txt"));
    fs::create_symlink("a.txt", path("b.txt"));
    EXPECT_EQ(error_of([&] { write_file(path("a.txt"), "x"); }),
              "cannot write " + path("a.txt") + ": Too many levels of symbolic links");
}

TEST_F(FileWriteTest, APipeAndADeviceGetTheBytes) {
    const std::string pipe = path("pipe.txt");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string bytes(300'000, 'x'); // more than a pipe holds
    bytes += "end";
    std::future<std::string> read = std::async(std::launch::async, [&] { return content(pipe); });
    write_file(pipe, bytes);
    EXPECT_EQ(read.get(), bytes);
    EXPECT_TRUE(fs::is_fifo(pipe));
    write_file("/dev/null", bytes);
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_EQ(error_of([&] { write_file("/dev/full", bytes); }),
              "cannot write /dev/full: No space left on device");
    EXPECT_EQ(files(), 1);
}

TEST_F(FileWriteTest, TakesAwayWhatAKilledProgramLeftAndNothingElse) {
    const std::string left = path(".a.txt.part-abcdefghijkl.txt");
    const std::string in_use = path(".a.txt.part-bbbbbbbbbbbb.txt");
    const std::string others[] = {path(".b.txt.part-abcdefghijkl.txt"), path(".a.txt.part-abc.txt"),
                                  path(".a.txt.part-ABCDEFGHIJKL.txt"), path("a.txt.part"), in_use};
    std::ofstream(left) << "half";
    for (const std::string& other : others)
        std::ofstream(other) << "other";
    const int descriptor = open(in_use.c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_EQ(flock(descriptor, LOCK_EX), 0);
    write_file(path("a.txt"), "whole");
    EXPECT_FALSE(fs::exists(left));
    for (const std::string& other : others)
        EXPECT_TRUE(fs::exists(other)) << other;
    close(descriptor);
    write_file(path("a.txt"), "whole");
    EXPECT_FALSE(fs::exists(in_use));
    EXPECT_EQ(files(), 5); // a.txt and four others
}

TEST_F(FileWriteTest, KeepsPermissionsAndTakesTheLongestName) {
    write_file(path("a.txt"), "old");
    ASSERT_EQ(chmod(path("a.txt").c_str(), 0640), 0);
    write_file(path("a.txt"), "new");
    struct stat status {};
    ASSERT_EQ(stat(path("a.txt").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0640U);
    const std::string longest = std::string(251, 'n') + ".txt";
    write_file(path(longest), "long");
    EXPECT_EQ(content(path(longest)), "long");
    EXPECT_EQ(error_of([&] { write_file(path("n" + longest), ""); }),
              "cannot write " + path("n" + longest) + ": File name too long");
}

TEST_F(FileWriteTest, TemporaryNamesCannotBeForeseen) {
    const TemporaryFile a(path("a.txt"));
    const TemporaryFile b(path("a.txt"));
    EXPECT_NE(a.path(), b.path());
    EXPECT_EQ(fs::path(a.path()).parent_path(), folder_.path());
    EXPECT_TRUE(fs::path(a.path()).filename().string().starts_with(".a.txt.part-"));
    EXPECT_EQ(extension(a.path()), "txt");
}

TEST_F(FileWriteTest, InputsAreFiles) {
    const std::string pipe = path("pipe.lua");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(error_of([&] { read_file(pipe); }), pipe + ": is a pipe, not a file");
    EXPECT_EQ(error_of([] { read_file("/dev/zero"); }), "/dev/zero: is a device, not a file");
    EXPECT_EQ(error_of([] { read_file("/proc/self/maps"); }),
              "/proc/self/maps: is made by the kernel, not a file on a disk");
}

} // namespace
} // namespace scree
