// SPDX-License-Identifier: GPL-3.0-or-later
// Compositing of pictures, against brute force.
#include "core/canvas.h"
#include "core/random.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scree {
namespace {

// Soft blobs of colour whose finest detail is about a tenth of the picture.
std::array<float, 4> blobs(double x, double y) {
    const auto wave = [](double v) { return static_cast<float>(0.5 + 0.5 * std::sin(v)); };
    const double r = std::hypot(x - 0.5, y - 0.5);
    const auto alpha = static_cast<float>(std::clamp(2.5 - 6 * r, 0.0, 1.0));
    return {wave(19 * x), wave(13 * y + 3 * x), wave(17 * r), alpha};
}

PicturePlace turned(const Vec2& centre, double width, double height, double angle) {
    const Vec2 u = rotate({width, 0}, angle), v = rotate({0, height}, angle);
    return {centre - (u + v) / 2, u, v};
}

/// Composites the look by brute force, with 32 x 32 points per pixel.
void brute_force(Image& image, const test::Look& look, const PicturePlace& place) {
    constexpr int n = 32;
    const double area = cross(place.u, place.v);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            std::array<double, 4> sum{};
            for (int i = 0; i < n * n; ++i) {
                const int row = i / n;
                const Vec2 d = Vec2(x + (i % n + 0.5) / n, y + (row + 0.5) / n) - place.origin;
                const double u = cross(d, place.v) / area, v = cross(place.u, d) / area;
                if (u < 0 || v < 0 || u > 1 || v > 1)
                    continue;
                const std::array<float, 4> value = look(u, v);
                for (std::size_t c = 0; c < 4; ++c)
                    sum[c] += double(c < 3 ? value[c] * value[3] : value[3]) / (n * n);
            }
            for (std::size_t c = 0; c < 4; ++c) {
                float& pixel = image.at(x, y)[c];
                pixel = static_cast<float>(sum[c] + double(pixel) * (1 - sum[3]));
            }
        }
}

struct Difference {
    double mean = 0, largest = 0;
};

Difference difference(const Image& a, const Image& b) {
    Difference out;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double d = std::abs(double(a.pixels[i]) - double(b.pixels[i]));
        out.mean += d / double(a.pixels.size());
        out.largest = std::max(out.largest, d);
    }
    return out;
}

// Pictures enlarged, shrunk by up to 10, rotated, sheared and stretched, over each other.
TEST(PictureFilter, CompositesAsBruteForceDoes) {
    const PictureFilter filter(test::picture_of(300, 300, blobs), Beyond::clamped);
    const PicturePlace places[] = {
        turned({30, 30}, 50, 50, 0.4),   turned({90, 40.3}, 80, 80, 2),
        turned({40.7, 95}, 30, 30, -1),  turned({100, 100}, 60, 25, 0.8),
        {{60, 70}, {40, 10}, {-25, 20}}, turned({70, 64}, 60, 60, 0),
        turned({20, 110}, -40, 40, 0.3),
    };
    Canvas canvas(128, 128);
    Image expected(128, 128, {"R", "G", "B", "A"});
    for (const PicturePlace& place : places) {
        canvas.draw(filter, place);
        brute_force(expected, blobs, place);
    }
    const Difference d = difference(canvas.image(), expected);
    EXPECT_LT(d.mean, 0.002);
    EXPECT_LT(d.largest, 0.03);
    RecordProperty("mean", std::to_string(d.mean));
    RecordProperty("largest", std::to_string(d.largest));

    const PictureFilter coarse(test::picture_of(24, 24, blobs), Beyond::clamped);
    Canvas grown(128, 128);
    grown.draw(coarse, turned({64, 64}, 110, 110, 0.5));
    Image wanted(128, 128, {"R", "G", "B", "A"});
    brute_force(wanted, blobs, turned({64, 64}, 110, 110, 0.5));
    EXPECT_LT(difference(grown.image(), wanted).mean, 0.02); // 24 pixels do not determine more
}

// The edges of an opaque rectangle equal those of the same polygon.
TEST(PictureFilter, EdgesCoverTheirExactArea) {
    const PictureFilter filter(test::picture_of(64, 32,
                                                [](double, double) {
                                                    return std::array{0.2F, 0.5F, 0.8F, 1.0F};
                                                }),
                               Beyond::clamped);
    const PicturePlace place = turned({31.3, 29.8}, 40, 18, 0.7);
    Canvas drawn(64, 64), filled(64, 64);
    drawn.draw(filter, place);
    const Ring ring{place.origin, place.origin + place.u, place.origin + place.u + place.v,
                    place.origin + place.v};
    filled.fill({&ring, 1}, Color(0.2F, 0.5F, 0.8F));
    EXPECT_LT(difference(drawn.image(), filled.image()).largest, 1e-5);
}

// A zone plate, whose rings get finer than pixels towards the outside, fades to its mean.
TEST(PictureFilter, FineDetailFadesInsteadOfAliasing) {
    constexpr int size = 1024;
    const auto plate = [](double x, double y) {
        const double r2 = ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)) * size * size;
        const auto v =
            static_cast<float>(0.5 + 0.5 * std::cos(pi * r2 / size)); // r / size per texel
        return std::array{v, v, v, 1.0F};
    };
    const PictureFilter filter(test::picture_of(size, size, plate), Beyond::clamped);
    for (const double factor : {2.5, 4.0, 5.7, 9.0}) {
        const double side = size / factor;
        for (const double angle : {0.0, 0.3, pi / 4}) {
            Canvas canvas(int(side) + 2, int(side) + 2);
            canvas.draw(filter,
                        turned({side / 2 + 1, side / 2 + 1}, 1.5 * side, 1.5 * side, angle));
            double worst = 0;
            for (int y = 2; y < canvas.image().height - 2; ++y)
                for (int x = 2; x < canvas.image().width - 2; ++x) {
                    const double r = std::hypot(x - side / 2, y - side / 2); // [pixels]
                    // Cycles per pixel there: r in texels / size cycles per texel.
                    const double texels = factor / 1.5;
                    const double cycles = r * texels / size * texels;
                    if (cycles > 1.0 && r * texels < 0.45 * size)
                        worst = std::max(worst, std::abs(double(canvas.image().at(x, y)[0]) - 0.5));
                }
            EXPECT_LT(worst, 0.06) << factor << " " << angle;
        }
    }
}

TEST(PictureFilter, RepeatedPicturesHaveNoSeam) {
    const auto waves = [](double x, double y) {
        const auto v =
            static_cast<float>(0.5 + 0.25 * std::sin(2 * pi * x + 1) + 0.25 * std::cos(4 * pi * y));
        return std::array{v, 1 - v, 0.5F, 1.0F};
    };
    // Odd sizes, so that texels of mip levels do not align with pixels.
    const PictureFilter filter(test::picture_of(237, 155, waves), Beyond::repeated);
    Canvas canvas(60, 40);
    canvas.draw(filter, {{0, 0}, {60, 0}, {0, 40}});
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x)
            EXPECT_NEAR(canvas.image().at(x, y)[0], waves((x + 0.5) / 60, (y + 0.5) / 40)[0], 0.01);
    for (int i = 0; i < filter.levels() - 3; ++i)
        EXPECT_NEAR(filter.trilinear({0.0, 0.3}, 0)[0], filter.trilinear({1.0, 0.3}, 0)[0], 1e-6);
}

TEST(PictureFilter, TrilinearAveragesOverItsWidth) {
    Random random(3, Purpose::test, 0);
    const PictureFilter filter(
        test::picture_of(256, 64,
                         [&](double, double) {
                             return std::array{random.uniform_float(), 0.0F, 0.0F, 1.0F};
                         }),
        Beyond::clamped);
    EXPECT_NEAR(filter.trilinear({0.5, 0.5}, 1)[0], 0.5, 0.05);
    // (0, 0) is the lower left pixel.
    EXPECT_EQ(filter.trilinear({0, 0}, 0)[0], filter.level(0).at(0, 63)[0]);
    EXPECT_EQ(filter.trilinear({1.0, 1.0}, 0)[0], filter.level(0).at(255, 0)[0]);
}

} // namespace
} // namespace scree
