// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/device.h"
#include "core/error.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>

namespace scree {

namespace {

const char* const doubling = "kernel void twice(global int* data, int add) {"
                             "  data[get_global_id(0)] = 2 * data[get_global_id(0)] + add; }";

std::vector<int> run_doubling() {
    Device device;
    std::vector<int> data(1000);
    std::iota(data.begin(), data.end(), 0);
    const Device::BufferHandle buffer = device.allocate(data.size() * sizeof(int));
    device.write(buffer, data.data(), data.size() * sizeof(int));
    const std::size_t size = data.size();
    const Device::Argument arguments[] = {buffer, std::int32_t{7}};
    device.run(doubling, "twice", {&size, 1}, arguments);
    device.read(buffer, data.data(), data.size() * sizeof(int));
    return data;
}

void expect_doubled() {
    const std::vector<int> data = run_doubling();
    for (std::size_t i = 0; i < data.size(); ++i)
        ASSERT_EQ(data[i], 2 * int(i) + 7);
}

class DeviceTest : public testing::Test {
  protected:
    void SetUp() override {
        setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1);
        // PoCL has a cache too, which must not be in the temporary folder of a test.
        setenv("POCL_CACHE_DIR", std::filesystem::temp_directory_path().c_str(), 0);
    }

    std::vector<std::filesystem::path> cached() const {
        std::vector<std::filesystem::path> files;
        if (std::filesystem::exists(folder_.path() / "scree"))
            for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "scree"))
                if (entry.path().filename().string().starts_with("kernel-"))
                    files.push_back(entry.path());
        return files;
    }

    test::Folder folder_;
};

TEST_F(DeviceTest, RunsAKernelAndCachesIt) {
    expect_doubled();
    ASSERT_EQ(cached().size(), 1U);
    const auto time = std::filesystem::last_write_time(cached()[0]);
    expect_doubled();
    ASSERT_EQ(cached().size(), 1U);
    EXPECT_EQ(std::filesystem::last_write_time(cached()[0]), time); // used, not written again
}

TEST_F(DeviceTest, IgnoresADamagedCache) {
    expect_doubled();
    ASSERT_EQ(cached().size(), 1U);
    const auto size = std::filesystem::file_size(cached()[0]);
    {
        std::fstream file(cached()[0], std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(std::streamoff(size / 2));
        file.write("damaged", 7);
    }
    expect_doubled();
    std::filesystem::resize_file(cached()[0], size / 3);
    expect_doubled();
    std::filesystem::resize_file(cached()[0], 0);
    expect_doubled();
    // Written again and used. Its bytes may differ, since PoCL adds the parts compiled so far.
    EXPECT_GT(std::filesystem::file_size(cached()[0]), 0U);
    const auto time = std::filesystem::last_write_time(cached()[0]);
    expect_doubled();
    EXPECT_EQ(std::filesystem::last_write_time(cached()[0]), time);
}

TEST_F(DeviceTest, IgnoresACacheThatCannotBeWritten) {
    setenv("XDG_CACHE_HOME", "/proc", 1); // not writable even for root
    expect_doubled();
}

TEST_F(DeviceTest, ShowsTheCompilersLog) {
    Device device;
    const std::size_t size = 1;
    try {
        device.run("kernel void broken() { no_such_thing; }", "broken", {&size, 1}, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::resource);
        EXPECT_NE(std::string(error.what()).find("no_such_thing"), std::string::npos);
    }
}

TEST_F(DeviceTest, ListsTheDevicesWhenNoneMatches) {
    const Device device("no such device");
    try {
        device.name();
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::resource);
        const std::string text = error.what();
        EXPECT_NE(text.find("no OpenCL device \"no such device\"; devices here: "),
                  std::string::npos);
        if (!Device::names().empty()) {
            EXPECT_NE(text.find(Device::names()[0]), std::string::npos);
        }
    }
}

TEST_F(DeviceTest, RefusesAWrongArgument) {
    Device device;
    const Device::BufferHandle buffer = device.allocate(4);
    const std::size_t size = 1;
    const Device::Argument arguments[] = {buffer, std::uint64_t{7}}; // 8 bytes for an int
    EXPECT_THROW(device.run(doubling, "twice", {&size, 1}, arguments), Error);
}

} // namespace

} // namespace scree
