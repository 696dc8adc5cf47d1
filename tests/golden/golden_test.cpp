// SPDX-License-Identifier: GPL-3.0-or-later
// Compares small pictures with references of many samples. Blocks of pixels are z-tested with both
// variances and Sidak's correction for their number, so that noise passes and even an invisible
// bias fails. The picture of a failed test is kept in the build folder. To update the references
// after an intended change: SCREE_MAKE_GOLDEN=1 ./golden_tests
#include "core/file.h"
#include "core/image.h"
#include "render/film/color.h"
#include "session/render_scene.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace scree {
namespace {

constexpr int reference_samples = 2048;
constexpr int block = 8;              // pixels; means of 64 pixels are almost normal
constexpr double significance = 1e-3; // of one picture

std::vector<ImagePart> render_parts(const std::string& script, int samples, std::uint64_t seed) {
    Session session({.path = script});
    const Scene scene = session.bake(session.load());
    RenderOptions options;
    options.samples = samples;
    options.seed = seed;
    const RenderResult result = render_scene(session, scene, options).result;
    EXPECT_EQ(result.stats.invalid_samples, 0U);
    std::vector<ImagePart> parts = result.film.parts();
    std::erase_if(parts, [](const ImagePart& part) {
        return part.name != "beauty" && part.name != "variance";
    });
    for (ImagePart& part : parts)
        part.full_float = false;
    return parts;
}

struct BlockMeans {
    double mean = 0;
    double variance = 0; // of that mean
};

BlockMeans block_of(const std::vector<ImagePart>& parts, int bx, int by, int channel) {
    const Image& beauty = parts[0].image;
    const Image& variance = parts[1].image;
    BlockMeans out;
    int count = 0;
    for (int y = by * block; y < std::min((by + 1) * block, beauty.height); ++y)
        for (int x = bx * block; x < std::min((bx + 1) * block, beauty.width); ++x) {
            out.mean += double(beauty.at(x, y)[channel]);
            out.variance += double(variance.at(x, y)[channel]);
            ++count;
        }
    out.mean /= count;
    out.variance /= double(count) * count;
    return out;
}

double worst_z(const std::vector<ImagePart>& a, const std::vector<ImagePart>& b) {
    const Image& image = a[0].image;
    double worst = 0;
    for (int by = 0; by * block < image.height; ++by)
        for (int bx = 0; bx * block < image.width; ++bx)
            for (int c = 0; c < 3; ++c) {
                const BlockMeans x = block_of(a, bx, by, c);
                const BlockMeans y = block_of(b, bx, by, c);
                // The rounding error of the reference's 16-bit floats: 2^-11 of the value.
                const double rounding = x.mean * 0x1p-11;
                const double sigma = std::sqrt(x.variance + y.variance + rounding * rounding);
                worst = std::max(worst, std::abs(x.mean - y.mean) / std::max(sigma, 1e-6));
            }
    return worst;
}

class Golden : public testing::TestWithParam<const char*> {};

TEST_P(Golden, PictureIsThatOfTheReference) {
    const std::string folder = std::string(SCREE_SOURCE_DIR) + "/tests/golden/";
    const std::string script = folder + GetParam() + ".lua";
    const std::string reference = folder + GetParam() + ".exr";
    if (std::getenv("SCREE_MAKE_GOLDEN") != nullptr) {
        write_exr(reference, render_parts(script, reference_samples, 1), {});
        return;
    }
    const std::vector<ImagePart> expected = read_exr(reference).parts;
    const std::vector<ImagePart> actual = render_parts(script, 0, 2);
    ASSERT_EQ(expected.size(), 2U);
    ASSERT_EQ(expected[0].image.width, actual[0].image.width);
    const int count = 3 * ((actual[0].image.width + block - 1) / block) *
                      ((actual[0].image.height + block - 1) / block);
    const double z = worst_z(expected, actual);
    EXPECT_LT(z, test::sidak_quantile(significance, count));
    if (z >= test::sidak_quantile(significance, count)) {
        write_exr(std::string(GetParam()) + "_failed.exr", actual, {});
        write_png(std::string(GetParam()) + "_failed.png", to_display(actual[0].image));
    }
    // The test is sensitive: a picture that is 2% brighter fails.
    std::vector<ImagePart> brighter = actual;
    for (float& value : brighter[0].image.pixels)
        value *= 1.02F;
    EXPECT_GT(worst_z(expected, brighter), test::sidak_quantile(significance, count));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden,
                         testing::Values("materials", "layout", "pile", "elements", "leather",
                                         "solid", "rocks"),
                         [](const auto& which) { return std::string(which.param); });

} // namespace
} // namespace scree
