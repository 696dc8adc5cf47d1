// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image.h"

#include "core/error.h"
#include "core/file.h"
#include "core/random.h"
#include "tests/support/folder.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace scree {
namespace {

std::string temporary(const std::string& name) {
    static const test::Folder folder;
    return folder.file(name);
}

Image ramp(int width, int height, std::vector<std::string> channels) {
    Image image(width, height, std::move(channels));
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<float>(i % 251) / 250.0F;
    return image;
}

TEST(Image, ExrKeepsPartsChannelsAndMetadata) {
    const std::string path = temporary("parts.exr");
    std::vector<ImagePart> parts = {{"beauty", ramp(17, 9, {"R", "G", "B", "A"}), true},
                                    {"Z", ramp(17, 9, {"Z"}), true},
                                    {"N", ramp(17, 9, {"X", "Y", "Z"}), false}};
    parts[1].image.pixels[3] = 1e30F;
    write_exr(path, parts, {{"scree", "0.1.0"}, {"worldSize", "2 3"}});
    const ExrFile read = read_exr(path);
    ASSERT_EQ(read.parts.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(read.parts[i].name, parts[i].name);
        EXPECT_EQ(read.parts[i].image.channels, parts[i].image.channels);
        EXPECT_EQ(read.parts[i].full_float, parts[i].full_float);
        for (std::size_t k = 0; k < parts[i].image.pixels.size(); ++k) {
            const float expected = parts[i].image.pixels[k];
            ASSERT_NEAR(read.parts[i].image.pixels[k], expected,
                        parts[i].full_float ? 0.0F : expected * 0x1p-11F);
        }
    }
    EXPECT_EQ(read.metadata, (Metadata{{"scree", "0.1.0"}, {"worldSize", "2 3"}}));
    EXPECT_EQ(read_image(path).pixels, parts[0].image.pixels);
}

TEST(Image, PngRoundTripIsWithinOneStepAndLinear) {
    for (const auto& channels :
         std::vector<std::vector<std::string>>{{"Y"}, {"R", "G", "B"}, {"R", "G", "B", "A"}}) {
        const std::string path = temporary("round.png");
        Image image = ramp(40, 30, channels);
        for (std::size_t i = 3; channels.size() == 4 && i < image.pixels.size(); i += 4)
            image.pixels[i] = 1; // opaque, since reading premultiplies
        write_png(path, image);
        const Image read = read_image(path);
        ASSERT_EQ(read.channels, channels);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const float v = image.pixels[i];
            const bool alpha = channels.size() == 4 && i % 4 == 3;
            const auto linear = [&](float s) {
                return alpha           ? s
                       : s <= 0.04045F ? s / 12.92F
                                       : std::pow((s + 0.055F) / 1.055F, 2.4F);
            };
            EXPECT_GE(read.pixels[i], linear(std::max(0.0F, v - 1 / 255.0F)) - 1e-5F);
            EXPECT_LE(read.pixels[i], linear(std::min(1.0F, v + 1 / 255.0F)) + 1e-5F);
        }
    }
}

// Values that 8 bits cannot tell apart.
TEST(Image, APngOf16BitsKeepsSmallSteps) {
    const std::string path = temporary("deep.png");
    Image image(256, 1, {"Y"});
    for (int x = 0; x < 256; ++x)
        image.pixels[std::size_t(x)] = static_cast<float>(30000 + x) / 65535;
    write_png(path, image, {}, PngDepth::sixteen);
    const Image read = read_data_image(path);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        ASSERT_NEAR(read.pixels[i], image.pixels[i], 0.01F / 65535);
}

TEST(Image, DitherKeepsExactStepsAndTheMean) {
    const std::string path = temporary("dither.png");
    Image image(64, 64, {"Y"});
    for (const float v : {0.0F, 100 / 255.0F, 1.0F}) {
        std::fill(image.pixels.begin(), image.pixels.end(), v);
        write_png(path, image);
        const Image read = read_image(path);
        for (const float p : read.pixels)
            ASSERT_FLOAT_EQ(p, read.pixels[0]);
    }
    std::fill(image.pixels.begin(), image.pixels.end(), 100.25F / 255);
    write_png(path, image);
    const Image read = read_image(path);
    const float low = *std::min_element(read.pixels.begin(), read.pixels.end());
    const auto high =
        std::count_if(read.pixels.begin(), read.pixels.end(), [&](float p) { return p > low; });
    EXPECT_EQ(high, 64 * 64 / 4);
}

TEST(Image, ForeignAndBrokenFilesAreInputErrors) {
    const std::string path = temporary("broken.exr");
    const auto fault = [&](const std::string& bytes) {
        write_file(path, bytes);
        try {
            read_image(path);
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
            return error.fault() == Fault::input;
        }
        return false;
    };
    EXPECT_TRUE(fault(""));
    EXPECT_TRUE(fault("BM this is no bitmap of ours"));
    const std::vector<ImagePart> parts = {{"beauty", ramp(32, 32, {"R", "G", "B"}), true}};
    write_exr(path, parts, {});
    std::string bytes = read_file(path);
    for (std::size_t cut : {8U, 64U, 300U, static_cast<unsigned>(bytes.size() - 40)})
        EXPECT_TRUE(fault(bytes.substr(0, cut))) << cut;
    write_png(temporary("whole.png"), parts[0].image);
    bytes = read_file(temporary("whole.png"));
    for (std::size_t cut : {8U, 20U, 60U, static_cast<unsigned>(bytes.size() / 2)})
        EXPECT_TRUE(fault(bytes.substr(0, cut))) << cut;
    EXPECT_THROW(read_image(temporary("no_such_file.png")), Error);
}

TEST(Image, AFullDiskLeavesTheOldFileIntact) {
    // A limit on file size fails writes in the middle just as a full disk does.
    std::vector<ImagePart> parts = {{"beauty", ramp(300, 300, {"R", "G", "B"}), true}};
    Random random(1, Purpose::test);
    for (float& v : parts[0].image.pixels)
        v = random.uniform_float(); // incompressible
    for (const std::string name : {"full.exr", "full.png"}) {
        const std::string path = temporary(name);
        write_file(path, "old");
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        for (const rlim_t room : {0U, 100U, 20000U}) {
            const rlimit small{room, before.rlim_max};
            setrlimit(RLIMIT_FSIZE, &small);
            Fault fault = Fault::usage;
            try {
                if (name == "full.exr")
                    write_exr(path, parts, {});
                else
                    write_png(path, parts[0].image);
            } catch (const Error& error) {
                fault = error.fault();
            }
            setrlimit(RLIMIT_FSIZE, &before);
            EXPECT_EQ(fault, Fault::resource) << name << " with room for " << room;
            EXPECT_TRUE(read_file(path) == "old") << name << " with room for " << room;
        }
        std::signal(SIGXFSZ, handler);
        for (const auto& entry :
             std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()))
            EXPECT_EQ(entry.path().string().find("full.tmp"), std::string::npos);
    }
    EXPECT_THROW(write_exr("/no/such/folder/a.exr", parts, {}), Error);
}

} // namespace
} // namespace scree
