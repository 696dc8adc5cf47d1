// SPDX-License-Identifier: GPL-3.0-or-later
// Fields: their values, and that their bounds over boxes are correct and tight.
#include "core/error.h"
#include "core/image.h"
#include "core/random.h"
#include "shapes/field/grid_field.h"
#include "shapes/field/plain_fields.h"
#include "shapes/field/sampled_function.h"
#include "shapes/table.h"
#include "tests/support/folder.h"
#include "tests/support/plugin_params.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scree {
namespace {

double wrapped(double angle) { return angle - 360 * std::round(angle / 360); }

/// How far a value lies outside a range; for angles, modulo full turns.
double outside(const Field& field, double value, const Range& range) {
    if (field.period() > 0) {
        if (range.high - range.low >= field.period())
            return 0;
        const double middle = (range.low + range.high) / 2;
        value = middle + wrapped(value - middle);
    }
    return std::max({0.0, range.low - value, value - range.high});
}

SampleGrid random_grid(int columns, int rows, bool torus, bool angle, std::uint64_t seed) {
    SampleGrid grid{.columns = columns, .rows = rows};
    grid.first = {-1.0, 0.5};
    grid.step = {2.0 / columns, 3.0 / rows};
    grid.torus = torus;
    grid.angle = angle;
    Random random(seed, Purpose::test, 0);
    for (int i = 0; i < columns * rows; ++i)
        grid.values.push_back(static_cast<float>(random.uniform() * 400 - 20));
    return grid;
}

/// Directions that change slowly except at a vortex, so that most bounds are small.
SampleGrid vortex_grid(int columns, int rows, bool torus) {
    SampleGrid grid = random_grid(columns, rows, torus, true, 0);
    for (int z = 0; z < rows; ++z)
        for (int x = 0; x < columns; ++x)
            grid.values[std::size_t(z) * std::size_t(columns) + std::size_t(x)] =
                static_cast<float>(
                    degrees(std::atan2(z - 0.4 * rows + 0.3, x - 0.6 * columns + 0.2)));
    return grid;
}

TEST(GridField, NearestDoesNotInterpolate) {
    SampleGrid grid = random_grid(5, 4, false, false, 8);
    grid.stepped = true;
    const std::vector<float> values = grid.values;
    const Vec2 first = grid.first, step = grid.step;
    const GridField field(std::move(grid));
    for (int z = 0; z < 4; ++z)
        for (int x = 0; x < 5; ++x)
            for (const double shift : {-0.45, 0.0, 0.45})
                EXPECT_EQ(field.at(first + step * Vec2(x + shift, z - shift)),
                          double{values[std::size_t(z * 5 + x)]});
}

std::vector<std::pair<std::string, std::shared_ptr<const Field>>> all_fields() {
    std::vector<std::pair<std::string, std::shared_ptr<const Field>>> out;
    const auto grid = [&](const std::string& name, SampleGrid samples) {
        out.emplace_back(name, std::make_shared<GridField>(std::move(samples)));
    };
    for (const bool torus : {false, true})
        for (const bool angle : {false, true}) {
            const std::string suffix = std::string(torus ? " torus" : "") + (angle ? " angle" : "");
            grid("1 x 1" + suffix, random_grid(1, 1, torus, angle, 1));
            grid("1 x 5" + suffix, random_grid(1, 5, torus, angle, 2));
            grid("2 x 3" + suffix, random_grid(2, 3, torus, angle, 3));
            grid("9 x 4" + suffix, random_grid(9, 4, torus, angle, 4));
            grid("53 x 37" + suffix, random_grid(53, 37, torus, angle, 5));
            grid("200 x 133" + suffix, random_grid(200, 133, torus, angle, 6));
        }
    for (const bool torus : {false, true}) {
        SampleGrid nearest = random_grid(23, 31, torus, false, 7);
        nearest.stepped = true;
        grid(torus ? "nearest torus" : "nearest", nearest);
    }
    grid("vortex", vortex_grid(70, 41, false));
    grid("vortex torus", vortex_grid(70, 41, true));
    const Vec2 a(0.2, -0.3), b(1.1, 0.4);
    out.emplace_back("gradient", std::make_shared<GradientField>(a, b, Range{2, 5}, false));
    out.emplace_back("falling", std::make_shared<GradientField>(a, b, Range{5, -2}, false));
    out.emplace_back("radial", std::make_shared<GradientField>(a, b, Range{2, 5}, true));
    for (const double turn : {0.0, 90.0, -33.0, 350.0})
        out.emplace_back("whirl " + std::to_string(turn), std::make_shared<WhirlField>(a, turn));
    out.emplace_back("constant", std::make_shared<ConstantField>(7.5));
    return out;
}

Box2 random_box(Random& random) {
    // Sizes are log-uniform from 1e-6 to 10 m.
    const Vec2 middle(random.uniform() * 8 - 4, random.uniform() * 8 - 4);
    const double x = std::pow(10.0, 1 - 7 * random.uniform());
    const double z = random.uniform() < 0.5 ? x : std::pow(10.0, 1 - 7 * random.uniform());
    return {middle - Vec2(x, z), middle + Vec2(x, z)};
}

TEST(Field, NoValueLiesOutsideTheBounds) {
    for (const auto& [name, field] : all_fields()) {
        double worst = 0;
        for (std::uint64_t i = 0; i < 3000; ++i) {
            Random random(1, Purpose::test, i);
            const Box2 box = random_box(random);
            const Range range = field->over(box);
            ASSERT_LE(range.low, range.high) << name;
            for (int k = 0; k < 30; ++k) {
                // Includes corners and sides, where extremes lie.
                const auto share = [&] {
                    const double u = random.uniform() * 1.4 - 0.2;
                    return std::clamp(u, 0.0, 1.0);
                };
                const Vec2 p(box.min.x + share() * (box.max.x - box.min.x),
                             box.min.y + share() * (box.max.y - box.min.y));
                const Vec2 inside(std::clamp(p.x, box.min.x, box.max.x),
                                  std::clamp(p.y, box.min.y, box.max.y));
                worst = std::max(worst, outside(*field, field->at(inside), range));
            }
        }
        EXPECT_LE(worst, 1e-9) << name;
    }
}

// The bounds of small boxes converge to the value.
TEST(Field, BoundsApproachTheValue) {
    for (const auto& [name, field] : all_fields()) {
        int jumps = 0;
        constexpr int boxes = 2000;
        for (std::uint64_t i = 0; i < boxes; ++i) {
            Random random(2, Purpose::test, i);
            const Vec2 p(random.uniform() * 4 - 2, random.uniform() * 4 - 1);
            constexpr double half = 1e-7;
            const Range range = field->over({p - Vec2(half), p + Vec2(half)});
            // The steepest grid changes by 400 over 0.01 m.
            if (range.high - range.low > 2 * half * 1e5)
                ++jumps;
        }
        EXPECT_LE(jumps, name == "constant" ? 0 : boxes / 500) << name;
    }
}

TEST(Field, BoundsOfManyCellsComeNearTheExtremes) {
    const GridField field(random_grid(200, 133, false, false, 6));
    for (std::uint64_t i = 0; i < 200; ++i) {
        Random random(3, Purpose::test, i);
        const Vec2 middle(random.uniform() - 0.5, 1.5 + random.uniform());
        const Vec2 half(0.3);
        const Box2 wide(middle - half, middle + half);
        // 62 x 28 cells are covered by blocks of 16 x 16, so the bounds include up to 15 more
        // cells.
        const Vec2 slack(16 * 2.0 / 200, 16 * 3.0 / 133);
        const Box2 wider(wide.min - slack, wide.max + slack);
        const Range bounds = field.over(wide);
        // Exact bounds of the extended box, from smaller boxes.
        Range exact{1e9, -1e9};
        for (int z = 0; z < 40; ++z)
            for (int x = 0; x < 40; ++x) {
                const Vec2 step = wider.size() / 40;
                const Vec2 corner = wider.min + Vec2(x * step.x, z * step.y);
                const Range part = field.over({corner, corner + step});
                exact = {std::min(exact.low, part.low), std::max(exact.high, part.high)};
            }
        EXPECT_GE(bounds.low, exact.low);
        EXPECT_LE(bounds.high, exact.high);
    }
}

TEST(Field, GridInterpolatesAndEndsOrRepeats) {
    SampleGrid grid{.columns = 2, .rows = 2, .first = {0.5, 0.5}, .step = {1.0, 1.0}};
    grid.values = {0, 1, 2, 5};
    const GridField ends(grid);
    EXPECT_EQ(ends.at({0.5, 0.5}), 0);
    EXPECT_EQ(ends.at({1.5, 1.5}), 5);
    EXPECT_DOUBLE_EQ(ends.at({1.0, 0.5}), 0.5);
    EXPECT_DOUBLE_EQ(ends.at({1.0, 1.0}), 2.0);
    EXPECT_EQ(ends.at({-7, 9}), 2);
    grid.torus = true;
    const GridField repeats(grid);
    EXPECT_DOUBLE_EQ(repeats.at({2.0, 0.5}), 0.5);
    for (const Vec2& p : {Vec2(0.7, 0.9), Vec2(1.9, 0.1), Vec2(0.2, 1.6)})
        EXPECT_NEAR(repeats.at(p), repeats.at(p + Vec2(-6, 8)), 1e-12);
}

TEST(Field, AnglesTakeTheShorterWay) {
    SampleGrid grid{.columns = 2, .rows = 1, .values = {350, 20}, .angle = true};
    const GridField field(grid);
    EXPECT_NEAR(field.at({0.5, 0}), 5, 1e-9);
    EXPECT_NEAR(field.at({0.1, 0}), 353, 1e-9);
    const Range range = field.over({{0, 0}, {1, 0}});
    EXPECT_NEAR(range.low, 350, 1e-9);
    EXPECT_NEAR(range.high, 380, 1e-9);
}

// Neighbouring cells of an angle field agree along their sides.
TEST(Field, AnglesAreContinuousAcrossCells) {
    const GridField field(random_grid(20, 20, true, true, 9));
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(4, Purpose::test, i);
        const double side = -1.0 + 0.1 * random.below(20);
        const double z = random.uniform() * 3;
        EXPECT_LT(std::abs(wrapped(field.at({side - 1e-9, z}) - field.at({side + 1e-9, z}))), 1e-4);
    }
}

TEST(Field, WhirlTurnsFromOutwards) {
    const WhirlField rays({1, 1}, 0), circles({1, 1}, 90);
    EXPECT_NEAR(rays.at({1, 3}), 90, 1e-12);
    EXPECT_NEAR(rays.at({0, 1}), 180, 1e-12);
    EXPECT_NEAR(circles.at({3, 1}), 90, 1e-12);
    EXPECT_EQ(circles.period(), 360);
}

TEST(Field, GradientsAreConstantBeyond) {
    const GradientField straight({0, 0}, {2, 0}, {10, 20}, false);
    EXPECT_DOUBLE_EQ(straight.at({0.5, 7}), 12.5);
    EXPECT_EQ(straight.at({-1, 0}), 10);
    EXPECT_EQ(straight.at({3, 0}), 20);
    const GradientField round({0, 0}, {2, 0}, {10, 20}, true);
    EXPECT_DOUBLE_EQ(round.at({0, -1}), 15);
    const Range range = round.over({{-1, -1}, {1, 1}});
    EXPECT_DOUBLE_EQ(range.low, 10);
    EXPECT_NEAR(range.high, 10 + 5 * std::sqrt(2.0), 1e-12);
}

TEST(Field, InvalidSamplesAreRejected) {
    EXPECT_EQ(parse_samples("2 1 0.5 -3e2", 4).values, (std::vector<float>{0.5F, -300}));
    for (const char* text :
         {"", "2", "0 1", "2 1 3", "2 1 3 nan", "2 1 3 inf", "2 1 3 1e99", "2 1 3 4 5", "9 1 1",
          "-1 -1 1", "99999999999 1 1", "1 1 x", "2 1 3 4 x"})
        EXPECT_THROW(parse_samples(text, 4), Error) << text;
}

class ImageField : public testing::Test {
  protected:
    std::shared_ptr<const Field> read(const std::map<std::string, Value>& values) {
        std::map<std::string, Value> all = values;
        all["path"] = path_;
        return tests::make(field_table(), "image", all);
    }

    test::Folder folder_;
    std::string path_ = folder_.file("field.png");
};

TEST_F(ImageField, TopRowIsFarAndStoredValuesCount) {
    Image image(2, 2, {"R", "G", "B", "A"});
    // Far left red, far right green, near left blue at half alpha, near right grey 128.
    image.pixels = {
        1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 128 / 255.0F, 128 / 255.0F, 128 / 255.0F, 128 / 255.0F, 1};
    write_png(path_, image);
    const std::map<std::string, Value> size{{"width", 2.0}, {"depth", 4.0}};
    const auto with = [&](const std::string& channel, double high) {
        auto all = size;
        all["channel"] = channel;
        all["high"] = high;
        return read(all);
    };
    const Vec2 far_left(-0.5, -1), far_right(0.5, -1), near_left(-0.5, 1), near_right(0.5, 1);
    EXPECT_NEAR(with("r", 1)->at(far_left), 1, 1e-6);
    EXPECT_NEAR(with("g", 10)->at(far_right), 10, 1e-6);
    EXPECT_NEAR(with("b", 1)->at(near_left), 1, 1e-6); // not premultiplied
    EXPECT_NEAR(with("a", 1)->at(near_left), 128 / 255.0, 1e-6);
    EXPECT_NEAR(with("luminance", 1)->at(near_right), 128 / 255.0, 1e-6); // not converted to linear
    EXPECT_NEAR(with("luminance", 1)->at(far_right), 0.7152, 1e-6);
    EXPECT_NEAR(with("r", 1)->at({0, -1}), 0.5, 1e-6);
    EXPECT_NEAR(with("r", 1)->at({-9, -9}), 1, 1e-6);
}

TEST_F(ImageField, AnglesOfAWholeTurn) {
    Image image(2, 1, {"Y"});
    image.pixels = {0.9F, 0.1F}; // 230 and 26 of 255
    write_png(path_, image);
    const auto field = read({{"width", 2.0}, {"depth", 1.0}, {"angle", true}});
    const double left = 230 / 255.0 * 360, right = 26 / 255.0 * 360;
    EXPECT_NEAR(wrapped(field->at({0, 0}) - (left + right + 360) / 2), 0, 1.5);
    EXPECT_EQ(field->period(), 360);
}

} // namespace
} // namespace scree
