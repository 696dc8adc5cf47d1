// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/region_shapes.h"
#include "geometry/plane/region_tools.h"
#include "tests/support/component_checks.h"

#include <cctype>
#include <cstring>
#include <map>

namespace scree {
namespace {

using tests::area_of_wrong_normals;
using tests::component_mesh;
using tests::expect_sound;

TEST(Components, SheetsOfAnyOutlineBendAndStayClosed) {
    const auto outline = std::make_shared<const Region>(
        triangulate({star_ring(0.1, 0.3, 7), circle_ring(0.02, 16), circle_ring(0.01, 9)}));
    for (const double bend : {0.0, 1.0, -2.5}) {
        const Mesh mesh = component_mesh("sheet", {{"outline", outline},
                                                   {"curl", bend},
                                                   {"cup", 0.5 * bend},
                                                   {"twist", 0.3 * bend},
                                                   {"thickness", 0.001}});
        expect_sound(mesh, "sheet");
        EXPECT_NEAR(volume(mesh), 0.001 * area(*outline),
                    bend == 0 ? 1e-9 : 0.001 * area(*outline));
        const Vec3 size = bounds(mesh).size();
        if (bend == 0) {
            EXPECT_NEAR(size.y, 0.001F, 1e-7F);
            EXPECT_NEAR(double(size.x), bounds(*outline).size().x, 1e-6);
        } else {
            EXPECT_LT(double(size.x), bounds(*outline).size().x);
            EXPECT_GT(size.y, 0.01F);
        }
    }
}

TEST(Components, ExtrudeKeepsAreaAndStandsUp) {
    // An L whose leg extends to the far side (-z) on the left.
    const auto outline = std::make_shared<const Region>(
        triangulate({{{0, 0}, {0.03, 0}, {0.03, 0.01}, {0.01, 0.01}, {0.01, 0.04}, {0, 0.04}}}));
    for (const bool upright : {false, true}) {
        const Mesh mesh = component_mesh(
            "extrude", {{"outline", outline}, {"height", 0.005}, {"upright", upright}});
        expect_sound(mesh, "extrude");
        EXPECT_NEAR(volume(mesh), 0.0006 * 0.005, 1e-12);
        const Vec3 size = bounds(mesh).size();
        EXPECT_NEAR(upright ? size.y : size.z, 0.04F, 1e-7F);
        EXPECT_NEAR(upright ? size.z : size.y, 0.005F, 1e-7F);
        // The narrow end is on the near side (+z), or at the bottom.
        float narrow = -1;
        for (const Vec3& p : mesh.positions)
            if (upright ? p.y < 0.001F : p.z > 0.019F)
                narrow = std::max(narrow, p.x);
        EXPECT_NEAR(narrow, -0.005F, 1e-6F);
    }
    const auto star = std::make_shared<const Region>(triangulate(
        {{{0.02, 0}, {0.005, 0.005}, {0, 0.02}, {-0.005, 0.005}, {-0.02, 0}, {0, -0.01}}}));
    expect_sound(
        component_mesh("extrude", {{"outline", star}, {"height", 0.01}, {"rounding", 0.004}}),
        "rounded");
}

TEST(Components, AreSoundAtTheirDefaults) {
    const auto table = component_table();
    EXPECT_GE(table.plugins().size(), 20U);
    for (const Plugin<MakeMesh>& plugin : table.plugins()) {
        const Mesh mesh = plugin.make(tests::defaults(plugin.params, "mesh." + plugin.name));
        expect_sound(mesh, plugin.name);
        EXPECT_EQ(mesh.name, plugin.name);
        EXPECT_LT(mesh.triangles.size(), 25000U) << plugin.name;
        EXPECT_LT(area_of_wrong_normals(mesh), 1e-3 * area(mesh)) << plugin.name;
    }
}

// Each parameter in turn at its minimum and its maximum. Contradictory combinations must be
// reported.
TEST(Components, AreSoundAtExtremes) {
    const auto table = component_table();
    int made = 0;
    for (const Plugin<MakeMesh>& plugin : table.plugins()) {
        for (const ParamSpec& spec : plugin.params) {
            std::vector<Value> values;
            for (const std::string& choice : spec.choices)
                values.emplace_back(choice);
            if (spec.type == ParamType::boolean)
                values = {true, false};
            for (const auto& limit : {spec.min, spec.max}) {
                if (!limit)
                    continue;
                const double inside = spec.unit == "deg" ? radians(*limit) : *limit;
                values.push_back(spec.type == ParamType::integer
                                     ? Value(static_cast<std::int64_t>(*limit))
                                     : Value(inside));
            }
            for (const Value& value : values) {
                Params params = tests::defaults(plugin.params, "mesh." + plugin.name);
                params.set(spec.name, value);
                const std::string what =
                    plugin.name + "." + spec.name + " " + std::to_string(&value - values.data());
                try {
                    expect_sound(plugin.make(params), what);
                    ++made;
                } catch (const Error& refused) {
                    EXPECT_NE(refused.diagnostics().front().path, "") << what;
                } catch (const std::exception& problem) {
                    ADD_FAILURE() << what << ": " << problem.what();
                }
            }
        }
    }
    EXPECT_GT(made, 100);
}

TEST(Components, SizesScaleTheWholeShape) {
    for (const auto& [name, size] :
         std::vector<std::pair<std::string, std::string>>{{"banana", "length"},
                                                          {"rice", "length"},
                                                          {"chestnut", "width"},
                                                          {"jack", "size"},
                                                          {"duck", "length"},
                                                          {"tree", "height"},
                                                          {"letter", "size"},
                                                          {"star", "radius"},
                                                          {"heart", "width"},
                                                          {"gear", "radius"},
                                                          {"block", "size"},
                                                          {"pin", "height"}})
        for (const double value : {1e-4, 100.0})
            expect_sound(component_mesh(name, {{size, value}}), name + " " + std::to_string(value));
}

TEST(Components, TheSameParametersGiveTheSameBytes) {
    const auto table = component_table();
    for (const Plugin<MakeMesh>& plugin : table.plugins()) {
        const Mesh a = plugin.make(tests::defaults(plugin.params, "mesh." + plugin.name));
        const Mesh b = plugin.make(tests::defaults(plugin.params, "mesh." + plugin.name));
        ASSERT_EQ(a.positions.size(), b.positions.size());
        EXPECT_EQ(a.triangles, b.triangles) << plugin.name;
        EXPECT_EQ(
            std::memcmp(a.positions.data(), b.positions.data(), a.positions.size() * sizeof(Vec3)),
            0)
            << plugin.name;
        EXPECT_EQ(std::memcmp(a.normals.data(), b.normals.data(), a.normals.size() * sizeof(Vec3)),
                  0)
            << plugin.name;
    }
}

TEST(Components, PlaneFacesUpAndHasItsSize) {
    const Mesh mesh = component_mesh("plane", {{"size", 6.0}});
    EXPECT_EQ(bounds(mesh).size(), Vec3(6, 0, 6));
    EXPECT_NEAR(area(mesh), 36, 1e-4);
    for (const Vec3& n : mesh.normals)
        EXPECT_EQ(n, Vec3(0, 1, 0));
    const Mesh::Triangle t = mesh.triangles.front();
    const Vec3 face = (mesh.positions[t[1]] - mesh.positions[t[0]])
                          .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
    EXPECT_GT(face.y, 0);
}

TEST(Components, BoxVolumes) {
    EXPECT_NEAR(volume(component_mesh("box", {{"width", 0.2}, {"rounding", 0.0}})), 0.008, 1e-8);
    // A rounded box is the Minkowski sum of a box and a ball: Steiner's formula.
    const double r = 0.25 * 0.1;
    const double x = 0.3 - 2 * r;
    const double y = 0.2 - 2 * r;
    const double z = 0.1 - 2 * r;
    const double expected = x * y * z + 2 * r * (x * y + y * z + z * x) + pi * r * r * (x + y + z) +
                            4.0 / 3 * pi * r * r * r;
    const Mesh mesh =
        component_mesh("box", {{"width", 0.3}, {"height", 0.2}, {"depth", 0.1}, {"rounding", 0.5}});
    EXPECT_NEAR(volume(mesh) / expected, 1, 0.003);
    EXPECT_TRUE(bounds(mesh).size().equalWithAbsError(Vec3(0.3F, 0.2F, 0.1F), 1e-6F));
}

TEST(Components, RoundVolumes) {
    EXPECT_NEAR(volume(component_mesh("sphere", {{"radius", 0.5}})) / (4.0 / 3 * pi * 0.125), 1,
                0.005);
    EXPECT_NEAR(volume(component_mesh("torus", {{"radius", 0.5}, {"tube", 0.2}})) /
                    (2 * pi * pi * 0.5 * 0.04),
                1, 0.01);
    EXPECT_NEAR(
        volume(component_mesh("cylinder", {{"radius", 0.5}, {"height", 2.0}, {"rounding", 0.0}})) /
            (pi * 0.25 * 2),
        1, 0.005);
    EXPECT_NEAR(
        volume(component_mesh("cone", {{"radius", 0.5}, {"height", 2.0}, {"rounding", 0.0}})) /
            (pi * 0.25 * 2 / 3),
        1, 0.005);
}

TEST(Components, TextIsItsLettersInARow) {
    const Mesh word = component_mesh("text", {{"text", std::string("na goya")}, {"bevel", 0.0}});
    double sum = 0;
    for (const char c : std::string("NAGOYA")) {
        const Vec3 size = bounds(component_mesh("letter", {{"letter", std::string(1, c)}})).size();
        sum += double(size.x);
    }
    const Vec3 size = bounds(word).size();
    EXPECT_NEAR(double(size.x), sum + 0.06 * (5 * 0.13 + 3.0 / 7), 1e-5);
    EXPECT_NEAR(size.y, 0.06F, 1e-6F);
    EXPECT_NEAR(size.z, 1.6F / 7 * 0.06F, 1e-6F);
    const Mesh lying =
        component_mesh("text", {{"text", std::string("L")}, {"pose", std::string("lying")}});
    const Mesh letter = component_mesh("letter", {{"letter", std::string("L")}});
    EXPECT_NEAR(volume(lying), volume(letter), 1e-3 * volume(letter));
    EXPECT_EQ(bounds(lying).size(), bounds(letter).size());
}

TEST(Components, LongestSideIsTheLength) {
    for (const std::string name : {"banana", "duck"}) {
        const Vec3 size = bounds(component_mesh(name, {{"length", 0.5}})).size();
        EXPECT_NEAR(std::max({size.x, size.y, size.z}), 0.5F, 1e-5F) << name;
    }
}

TEST(Components, EveryLetterAndDigit) {
    for (const char c : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789z.-")) {
        const Mesh mesh = component_mesh("letter", {{"letter", std::string(1, c)}});
        expect_sound(mesh, std::string(1, c));
        if (std::isalnum(c) != 0 && c != 'Q') { // its tail extends below the baseline
            EXPECT_NEAR(bounds(mesh).size().z, 0.06F, 1e-4F) << c;
        }
    }
}

// Seen from above, the tail of the J is on the left, the foot of the L on the right.
TEST(Components, EvenTexturesOfABoxHaveOneScale) {
    const std::map<std::string, Value> sides{{"width", 0.2}, {"height", 0.1}, {"depth", 0.05}};
    std::map<std::string, Value> even = sides;
    even["uvs"] = std::string("even");
    for (const auto& [values, is_even] : {std::pair{sides, false}, std::pair{even, true}}) {
        const Mesh mesh = component_mesh("box", values);
        double largest = 0;
        for (std::size_t i = 0; i < mesh.uvs.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (i / (mesh.uvs.size() / 6) == j / (mesh.uvs.size() / 6)) {
                    const Vec3 d = mesh.positions[i] - mesh.positions[j];
                    const double flat = 0.2 * double((mesh.uvs[i] - mesh.uvs[j]).length());
                    // Edges are rounded: they go up to 3 mm down from their side.
                    largest = std::max(largest, std::abs(double(d.length()) - flat));
                }
        EXPECT_EQ(largest < 0.002, is_even) << largest;
    }
}

TEST(Components, LettersAreReadableFromAbove) {
    const auto low_part_middle = [](const std::string& letter) {
        const Mesh mesh = component_mesh("letter", {{"letter", letter}});
        const Box3 box = bounds(mesh);
        float sum = 0;
        int count = 0;
        for (const Vec3& p : mesh.positions)
            if (p.z > 0.5F * box.max.z) { // towards the viewer: the lower part
                sum += p.x;
                ++count;
            }
        return sum / static_cast<float>(count);
    };
    EXPECT_LT(low_part_middle("P"), 0);
    EXPECT_GT(low_part_middle("4"), 0);
}

TEST(Components, ContradictionsAreNamed) {
    const auto message = [](const std::string& name, const std::string& key, const Value& value) {
        try {
            component_mesh(name, {{key, value}});
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message("torus", "tube", 0.05),
              "scene.lua:7: mesh.torus.tube: must be less than the radius");
    EXPECT_EQ(message("letter", "letter", std::string("?")),
              "scene.lua:7: mesh.letter.letter: \"?\" is not one of A to Z, 0 to 9, . and -");
    EXPECT_EQ(message("bolt", "pitch", 1e-4),
              "scene.lua:7: mesh.bolt.pitch: the thread would have more than 200 turns");
}

// The crests of a right-handed thread rise to the right when seen from outside.
TEST(Components, BoltThreadIsRightHanded) {
    const Mesh mesh = component_mesh("bolt", {{"pose", std::string("standing")}});
    const float crest = 0.00399F;
    // Among crest vertices near +x (seen along -x, z to the left), y falls as z rises.
    double covariance = 0;
    const Box3 box = bounds(mesh);
    const float middle = 0.75F * box.max.y;
    for (const Vec3& p : mesh.positions)
        for (const Vec3& q : mesh.positions) {
            const bool both = std::hypot(p.x, p.z) > crest && std::hypot(q.x, q.z) > crest &&
                              std::abs(p.y - middle) < 0.002F && p.x > 0.003F && q.x > 0.003F;
            // Neighbours on one helix: their heights differ by less than half of the pitch.
            if (both && std::abs(p.y - q.y) < 0.0002F && q.z > p.z)
                covariance += double(q.y - p.y);
        }
    EXPECT_LT(covariance, 0);
}

} // namespace
} // namespace scree
