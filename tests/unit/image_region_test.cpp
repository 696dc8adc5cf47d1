// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of images against known areas and against the images.
#include "core/error.h"
#include "core/image.h"
#include "core/random.h"
#include "geometry/plane/image_outline.h"
#include "geometry/plane/region_tools.h"
#include "shapes/table.h"
#include "tests/support/folder.h"
#include "tests/support/plugin_params.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

namespace scree {
namespace {

struct Picture {
    int width;
    int height;
    std::vector<float> values;

    Picture(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}
    float& at(int x, int y) { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    float at(int x, int y) const {
        return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    PixelGrid grid() const { return {width, height, values}; }

    /// Draws the set where the signed distance `inside` [pixels] is positive, with an edge three
    /// pixels wide, so that interpolation reconstructs it.
    void draw(const auto& inside) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                at(x, y) = static_cast<float>(
                    std::clamp(0.5 + inside(Vec2(x + 0.5, y + 0.5)) / 3, 0.0, 1.0));
    }

    /// Bilinear interpolation between pixel centres.
    double between(const Vec2& p) const {
        const double u = p.x - 0.5, v = p.y - 0.5;
        const int x = std::clamp(int(std::floor(u)), 0, width - 2);
        const int y = std::clamp(int(std::floor(v)), 0, height - 2);
        const double s = u - x, t = v - y;
        return (1 - t) * ((1 - s) * at(x, y) + s * at(x + 1, y)) +
               t * ((1 - s) * at(x, y + 1) + s * at(x + 1, y + 1));
    }
};

double area_of(const std::vector<Ring>& rings) {
    double sum = 0;
    for (const Ring& ring : rings)
        sum += signed_area(ring);
    return sum;
}

TEST(ImageOutline, ADiskKeepsItsAreaToAThousandth) {
    Picture picture(200, 160);
    picture.draw([](const Vec2& p) { return 60 - (p - Vec2(97.3, 81.8)).length(); });
    std::vector<Ring> rings = image_outlines(picture.grid(), 0.5F, 4);
    ASSERT_EQ(rings.size(), 1U);
    EXPECT_NEAR(area_of(rings) / (pi * 60 * 60), 1, 1e-4);
    for (const Vec2& p : rings[0])
        EXPECT_NEAR((p - Vec2(97.3, 81.8)).length(), 60, 0.02); // sub-pixel accuracy
    const std::size_t before = rings[0].size();
    simplify_within(rings, 0.5);
    EXPECT_LT(rings[0].size(), before / 10);
    EXPECT_NEAR(area_of(rings) / (pi * 60 * 60), 1, 1e-2);
    for (const Vec2& p : rings[0])
        EXPECT_NEAR((p - Vec2(97.3, 81.8)).length(), 60,
                    0.02); // simplification does not move points
}

TEST(ImageOutline, HolesAndPartsHaveTheRightOrientation) {
    Picture picture(100, 50);
    picture.draw([](const Vec2& p) {
        const double ring = 5 - std::abs((p - Vec2(25, 25)).length() - 15);
        return std::max(ring, 8 - (p - Vec2(75, 25)).length());
    });
    const std::vector<Ring> rings = image_outlines(picture.grid(), 0.5F, 4);
    ASSERT_EQ(rings.size(), 3U);
    EXPECT_NEAR(area_of(rings), pi * (400 - 100 + 64), 1);
    int holes = 0;
    for (const Ring& ring : rings)
        holes += signed_area(ring) < 0 ? 1 : 0;
    EXPECT_EQ(holes, 1);
}

TEST(ImageOutline, AFullImageIsItsRectangleExceptTheCorners) {
    Picture picture(30, 20);
    std::fill(picture.values.begin(), picture.values.end(), 1.0F);
    const std::vector<Ring> rings = image_outlines(picture.grid(), 0.5F, 4);
    ASSERT_EQ(rings.size(), 1U);
    EXPECT_NEAR(area_of(rings), 600 - 4 * 0.125, 1e-9);
    const Box2 box = bounds(Region{rings, {}, {}});
    EXPECT_EQ(box.min, Vec2(0.0));
    EXPECT_EQ(box.max, Vec2(30, 20));
}

TEST(ImageOutline, DiagonalPixelsAreConnectedByTheirMean) {
    for (const double low : {0.0, 0.3}) {
        Picture picture(4, 4);
        std::fill(picture.values.begin(), picture.values.end(), 0.0F);
        picture.at(1, 1) = picture.at(2, 2) = 0.8F;
        picture.at(1, 2) = picture.at(2, 1) = static_cast<float>(low);
        const std::vector<Ring> rings = image_outlines(picture.grid(), 0.5F, 0);
        EXPECT_EQ(rings.size(), low == 0.0 ? 2U : 1U);
        EXPECT_NO_THROW(triangulate(rings));
    }
}

// For noise images of all kinds the rings form a valid region, before and after simplification, and
// contain exactly the points where the image is above the threshold.
TEST(ImageOutline, NoiseGivesValidRegions) {
    for (std::uint64_t i = 0; i < 40; ++i) {
        Random random(3, Purpose::test, i);
        Picture picture(2 + int(random.below(30)), 2 + int(random.below(30)));
        const std::uint32_t steps =
            2 + random.below(4); // few levels, so that many equal the threshold
        for (float& value : picture.values)
            value = i % 2 == 0 ? random.uniform_float()
                               : static_cast<float>(random.below(steps)) / float(steps - 1);
        const float threshold = i % 3 == 0 ? 1.0F : 0.5F;
        std::vector<Ring> rings = image_outlines(picture.grid(), threshold, 0);
        if (rings.empty())
            continue;
        const Region region = triangulate(rings);
        EXPECT_NEAR(area(region), area_of(rings), 1e-9) << i; // orientations are right
        for (int k = 0; k < 300; ++k) {
            const Vec2 p(random.uniform(0.5, picture.width - 0.5),
                         random.uniform(0.5, picture.height - 0.5));
            // In a cell the level line is a hyperbola, which the outline approximates by a chord.
            const double value = picture.between(p);
            const Vec2 middle(std::round(p.x - 0.5) + 0.5, std::round(p.y - 0.5) + 0.5);
            const bool clear = std::abs(value - double{threshold}) > 0.35;
            if ((p - middle).length() < 0.3 && clear) {
                EXPECT_EQ(contains(region, p), value > double{threshold}) << i;
            }
        }
        // All pixel centres.
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                EXPECT_EQ(contains(region, {x + 0.5, y + 0.5}), picture.at(x, y) >= threshold) << i;
        const std::vector<Ring> exact = rings;
        for (const double tolerance : {0.1, 0.5, 3.0}) {
            rings = exact;
            simplify_within(rings, tolerance);
            ASSERT_EQ(rings.size(), exact.size());
            const Region simple = triangulate(rings);
            EXPECT_NEAR(area(simple), area_of(rings), 1e-9) << i;
            for (std::size_t r = 0; r < exact.size(); ++r)
                for (const Vec2& p : exact[r]) {
                    const Region own{{rings[r]}, {}, {}};
                    EXPECT_LE(std::abs(signed_distance(own, p)), tolerance + 1e-9) << i;
                }
        }
    }
}

class ImageRegion : public testing::Test {
  protected:
    /// Writes a white image with this alpha.
    void write(const Picture& alpha) {
        Image image(alpha.width, alpha.height, {"R", "G", "B", "A"});
        for (std::size_t i = 0; i < alpha.values.size(); ++i) {
            std::fill_n(&image.pixels[4 * i], 3, 1.0F);
            image.pixels[4 * i + 3] = alpha.values[i];
        }
        write_png(path_, image);
    }

    /// The region of the image, simplified by at most 1/20 of a pixel unless `values` differ.
    Region read(std::map<std::string, Value> values) {
        values["path"] = path_;
        values.try_emplace("tolerance", 0.05);
        return tests::make(region_table(), "image", values);
    }

    test::Folder folder_;
    std::string path_ = folder_.file("region.png");
};

TEST_F(ImageRegion, SizeIsTheOutlinesAndWidthTheImages) {
    Picture picture(80, 40);
    picture.draw([](const Vec2& p) { // a bar in the far left quarter
        return std::min({p.x - 10, 30 - p.x, p.y - 5, 15 - p.y});
    });
    write(picture);
    const Box2 component = bounds(read({{"size", 0.2}}));
    EXPECT_NEAR((component.max - Vec2(0.1, 0.05)).length(), 0, 1e-3);
    EXPECT_NEAR((component.min + Vec2(0.1, 0.05)).length(), 0, 1e-3);
    const Box2 mask = bounds(read({{"width", 8.0}}));
    EXPECT_NEAR((mask.min - Vec2(-3, -1.5)).length(), 0, 1e-2);
    EXPECT_NEAR((mask.max - Vec2(-1, -0.5)).length(), 0, 1e-2);
    const Box2 stretched = bounds(read({{"width", 8.0}, {"depth", 8.0}}));
    EXPECT_NEAR((stretched.min - Vec2(-3, -3)).length(), 0, 1e-2);
    EXPECT_THROW(read({{"width", 8.0}, {"size", 1.0}}), Error);
    EXPECT_NEAR(area(read({{"width", 80.0}, {"invert", true}})) + area(read({{"width", 80.0}})),
                80 * 40 - 4 * 0.125, 2.0);
}

TEST_F(ImageRegion, WithoutAlphaLuminanceCounts) {
    Image image(20, 20, {"Y"});
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x)
            *image.at(x, y) = x < 10 ? 1.0F : 0.0F;
    write_png(path_, image);
    EXPECT_NEAR(area(read({{"width", 20.0}})), 200, 1);
}

TEST_F(ImageRegion, SpecksAndEmptyImages) {
    Picture picture(40, 40);
    picture.draw([](const Vec2& p) { return 10 - (p - Vec2(20, 20)).length(); });
    picture.at(2, 2) = 1;
    picture.at(20, 20) = 0;
    write(picture);
    EXPECT_EQ(read({{"width", 40.0}}).rings.size(), 1U);
    EXPECT_EQ(read({{"width", 40.0}, {"min_area", 0.0}}).rings.size(), 3U);
    try {
        read({{"threshold", 2.0}});
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "scene.lua:7: region.image.threshold: nothing of the image is at least 2 (a), "
                  "but for specks of less than min_area");
    }
}

// 4096 x 4096 pixels with 3,000 disks with holes. The time is that of the outline, without reading.
TEST(ImageOutline, BigImagesTakeSeconds) {
    Picture picture(4096, 4096);
    std::vector<Vec2> centres;
    Random random(5, Purpose::test, 0);
    for (int y = 0; y < 55; ++y)
        for (int x = 0; x < 55; ++x)
            centres.emplace_back(74 * x + 40 + random.uniform(-5, 5),
                                 74 * y + 40 + random.uniform(-5, 5));
    double want = 0;
    for (const Vec2& c : centres) {
        want += pi * (28 * 28 - 10 * 10);
        for (int y = int(c.y) - 32; y < int(c.y) + 32; ++y)
            for (int x = int(c.x) - 32; x < int(c.x) + 32; ++x) {
                const double r = (Vec2(x + 0.5, y + 0.5) - c).length();
                picture.at(x, y) =
                    static_cast<float>(std::clamp(0.5 + std::min(28 - r, r - 10), 0.0, 1.0));
            }
    }
    const std::clock_t start = std::clock();
    std::vector<Ring> rings = image_outlines(picture.grid(), 0.5F, 4);
    simplify_within(rings, 0.5);
    const Region region = triangulate(std::move(rings));
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_EQ(region.rings.size(), 2 * centres.size());
    EXPECT_NEAR(area(region) / want, 1, 0.02);
    EXPECT_LT(seconds, 20); // 6.6 s of a busy core were measured at -O1
    RecordProperty("seconds", std::to_string(seconds));
}

} // namespace
} // namespace scree
