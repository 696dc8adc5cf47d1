// SPDX-License-Identifier: GPL-3.0-or-later
// Deterministic mutations of small valid images: each must either give a physical image or be
// refused with an Error, in bounded time.
#include "core/error.h"
#include "core/file.h"
#include "core/image.h"
#include "core/random.h"
#include "tests/support/damaged.h"
#include "tests/support/image_bytes.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace scree {
namespace {

using namespace test;

std::string seed_png() {
    const std::string curve = std::string("curv\0\0\0\0\0\0\0\x01\x02\x33", 14);
    const std::string profile = icc_bytes("RGB ", {{"rXYZ", icc_xyz(0.436, 0.222, 0.014)},
                                                   {"gXYZ", icc_xyz(0.385, 0.717, 0.097)},
                                                   {"bXYZ", icc_xyz(0.143, 0.061, 0.714)},
                                                   {"rTRC", curve},
                                                   {"gTRC", curve},
                                                   {"bTRC", curve}});
    return png_bytes_of(2, 8, 6, {"abcdefgh", "ijklmnop"},
                        png_chunk("iCCP", std::string("p\0\0", 3) + stored(profile)) +
                            png_chunk("gAMA", big_endian(50000, 4)) +
                            png_chunk("eXIf", exif_bytes(6)));
}

std::string seed_hdr() {
    std::string pixels("\x02\x02\x00\x08\x88\x40\x08"
                       "abcdefgh\x88\x20\x88\x81",
                       19);
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\nPRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 "
           "0.3127 0.329\n\n+X 1 -Y 8\n" +
           pixels;
}

std::string seed_exr() {
    return exr_bytes({{"view.rgba.R", constant(4, 3, 0.5F)},
                      {"view.rgba.G", constant(4, 3, 0.25F)},
                      {"view.rgba.B", constant(4, 3, 0.125F)},
                      {"view.rgba.A", constant(4, 3, 1)}},
                     {-1, 0, 2, 2}, {0, 0, 3, 3});
}

TEST(ImageMutation, EveryDamagedImageReadsOrIsRefused) {
    const Folder folder;
    const std::vector<std::string> pieces{
        "IDAT", "iCCP", "acsp", "curv", "para", "text", "\xff\xff\xff\xff", std::string(4, '\0'),
        "-Y",   "1e9",  "=",    "\n",   ".",    "R",    "\xff\xe1",         "\x7f\xff\xff\xff"};
    for (const auto& [name, seed] : std::vector<std::pair<std::string, std::string>>{
             {"png", seed_png()},
             {"jpeg", jpeg_bytes(jpeg_segment(0xe1, std::string("Exif\0\0", 6) + exif_bytes(8)))},
             {"hdr", seed_hdr()},
             {"exr", seed_exr()}}) {
        int read = 0, refused = 0;
        double slowest = 0;
        EXPECT_NO_THROW(read_image(folder.write("a", seed))) << name;
        for (std::uint64_t i = 0; i < 400; ++i) {
            Random random(hash_bytes(seed), Purpose::test, i);
            const std::string path = folder.write("a", damaged(seed, pieces, random));
            const auto start = std::chrono::steady_clock::now();
            try {
                const Image image = read_image(path);
                for (const float v : image.pixels)
                    ASSERT_TRUE(std::isfinite(v) && v >= 0) << name << ' ' << i;
                ++read;
            } catch (const Error&) {
                ++refused;
            } catch (const std::exception& problem) {
                ADD_FAILURE() << name << ' ' << i << ": " << problem.what();
            }
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
            slowest = std::max(slowest, taken.count());
        }
        EXPECT_GT(read, 0) << name;
        EXPECT_GT(refused, 0) << name;
        EXPECT_LT(slowest, 10.0) << name;
    }
}

} // namespace
} // namespace scree
