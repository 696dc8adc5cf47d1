// SPDX-License-Identifier: GPL-3.0-or-later
// Fields in scripts: functions become samples in the sandbox, and JSON keeps them.
#include "core/file.h"
#include "geometry/plane/field.h"
#include "scenes/reader/json.h"
#include "scenes/reader/maker.h"
#include "scenes/reader/script.h"
#include "session/catalog.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

class ReaderField : public testing::Test {
  protected:
    DescriptionNode run(const std::string& script) {
        const std::string path = folder_.file("scene.lua");
        write_file(path, script);
        ScriptOptions options;
        options.families = catalog_.constructor_families();
        options.limits = {.seconds = 1, .memory = std::size_t{64} << 20};
        return run_script(path, options);
    }

    /// The field `f` of the table that the script returns, checked with the limits of a scale.
    std::shared_ptr<const Field> field(const DescriptionNode& node) {
        const std::vector<ParamSpec> specs{{.name = "f",
                                            .type = ParamType::field,
                                            .unit = "m",
                                            .fallback = 3.0,
                                            .min = 0.0,
                                            .max = 100.0,
                                            .above_min = true}};
        Mistakes mistakes;
        Maker maker(catalog_, mistakes);
        const Params params = maker.params(*node, "test", specs);
        mistakes.throw_if_any();
        return field_of(params, "f");
    }

    /// The error message for the script or its field, without the folder.
    std::string error_of(const std::string& script) {
        try {
            field(run(script));
        } catch (const Error& error) {
            std::string text = error.what();
            const std::string here = folder_.path().string() + "/";
            for (std::size_t at = 0; (at = text.find(here)) != std::string::npos;)
                text.erase(at, here.size());
            return text;
        }
        return "no error";
    }

    test::Folder folder_;
    const Catalog catalog_ = standard_catalog();
};

TEST_F(ReaderField, NumbersAndDefaultsAreConstantFields) {
    EXPECT_EQ(field(run("return { f = 7 }"))->at({3, 4}), 7);
    EXPECT_EQ(field(run("return { f = 0.5 }"))->at({3, 4}), 0.5);
    EXPECT_EQ(field(run("return {}"))->at({3, 4}), 3);
    EXPECT_EQ(error_of("return { f = 0 }"),
              "scene.lua: test.f: 0 m is out of range; expected more than 0 and at most 100 m");
    EXPECT_EQ(error_of("return { f = 0/0 }"),
              "scene.lua: test.f: is not a number; was zero divided by zero?");
    EXPECT_EQ(error_of("return { f = 'x' }"),
              "scene.lua: test.f: expected a field.* or a number, got the text \"x\"");
    EXPECT_EQ(error_of("return { f = mesh.box {} }"),
              "scene.lua: test.f: expected a field.* or a number, got mesh.box");
}

TEST_F(ReaderField, ValuesOfFieldsKeepTheLimits) {
    EXPECT_EQ(error_of("return { f = field.gradient {\n from = {0, 0}, to = {1, 0}, high = 2 } }"),
              "scene.lua: test.f: this field.gradient has values from 0 to 2 m; expected more than "
              "0 and at most 100 m");
    EXPECT_EQ(error_of("return { f = field.gradient {\n from = {0, 0}, to = {0, 0} } }"),
              "scene.lua:2: field.gradient.to: is the same point as from: {0, 0}");
    EXPECT_EQ(error_of("return { f = field.wirl {} }"),
              "scene.lua:1: field.wirl: unknown field\n  did you mean field.whirl?");
    // The limits do not apply to directions.
    EXPECT_EQ(field(run("return { f = field.whirl { turn = 0 } }"))->at({-1, 0}), 180);
}

TEST_F(ReaderField, FunctionsAreSampled) {
    const auto made = field(run("return { f = field.function {\n"
                                "value = function(x, z) return 30 + x + 10 * z end,\n"
                                "width = 2, depth = 4, resolution = 5 } }"));
    for (const Vec2& p : {Vec2(0, 0), Vec2(-1, 0.3), Vec2(0.77, -0.4), Vec2(1, 0.123)})
        EXPECT_NEAR(made->at(p), 30 + p.x + 10 * p.y,
                    1e-5); // linear functions are exact up to rounding
    EXPECT_NEAR(made->at({9, 0.5}), 36, 1e-5);
    const auto torus = field(run("return { f = field.function { torus = true, centre = {1, 0},\n"
                                 "value = function(x, z) return 2 + math.sin(math.pi * x) end,\n"
                                 "width = 2, depth = 1 } }"));
    for (double x = -3; x < 3; x += 0.01)
        EXPECT_NEAR(torus->at({x, 0.3}), 2 + std::sin(pi * x), 1e-4) << x;
}

TEST_F(ReaderField, FunctionCanBeWrittenInEveryWay) {
    const std::string table = " { value = function() return 2 end, width = 1, depth = 1 }";
    for (const std::string& script :
         {"return { f = field.function" + table + " }",
          "return { f = field[\"function\"]" + table + " }",
          "local f = field . function\nreturn { f = f(" + table + ") }",
          "local function make() return field.function" + table + " end\nreturn { f = make() }"})
        EXPECT_EQ(field(run(script))->at({0, 0}), 2) << script;
    // Elsewhere the keyword is unchanged, as are strings and comments.
    EXPECT_EQ(field(run("-- field.function\nlocal t = 'field.function'\n"
                        "local f = function() return #t end return { f = f() }"))
                  ->at({0, 0}),
              14);
}

TEST_F(ReaderField, JsonKeepsTheSamples) {
    const DescriptionNode node =
        run("return { f = field.function { value = function(x, z) return 2 + x * x / 3 end,\n"
            "width = 2, depth = 1, resolution = 33 } }");
    const std::string json = to_json(*node);
    const DescriptionNode again = description_from_json(json, "scene.json");
    EXPECT_EQ(to_json(*again), json);
    const auto one = field(node);
    const auto other = field(again);
    for (double x = -1; x < 1; x += 0.013)
        EXPECT_EQ(one->at({x, 0.2}), other->at({x, 0.2}));
}

TEST_F(ReaderField, MistakesInFunctionsAreNamed) {
    const auto with = [&](const std::string& body, const std::string& more = "") {
        return error_of("return { f = field.function {\nwidth = 1, depth = 1, " + more +
                        "\nvalue = function(x, z)\n" + body + "\nend } }");
    };
    EXPECT_EQ(with("return nothing_here"), "scene.lua:4: nothing_here is not known here");
    EXPECT_EQ(with("return"), "scene.lua:1: field.function.value: gives nothing at x = -0.5, z = "
                              "-0.5; expected a number");
    EXPECT_EQ(with("return x > 0.4 and 'far' or 1"),
              "scene.lua:1: field.function.value: gives a string at x = 0.401961, z = -0.5; "
              "expected a number");
    EXPECT_EQ(with("return 0/0"), "scene.lua:1: field.function.value: gives what is not a number "
                                  "(was zero divided by zero?) at x = -0.5, z = -0.5; expected a "
                                  "number");
    EXPECT_EQ(with("return 1/0"), "scene.lua:1: field.function.value: gives inf, which is too "
                                  "large at x = -0.5, z = -0.5; expected a number");
    EXPECT_EQ(with("while true do end"), "scene.lua:4: the script ran for more than 1 s; is "
                                         "there a loop that never ends?");
    EXPECT_EQ(with("return 1", "resolution = 1,"),
              "scene.lua:2: field.function.resolution: 1 is out of range; expected 2 to 1024");
    EXPECT_EQ(with("return 1", "centre = 'x',"),
              "scene.lua:2: field.function.centre: expected {x, z}, got the text \"x\"");
    EXPECT_EQ(error_of("return { f = field.function { value = 3, width = 1, depth = 1 } }"),
              "scene.lua:1: field.function.value: expected a function(x, z), got 3");
    EXPECT_EQ(error_of("return { f = field.function { value = print, depth = 1 } }"),
              "scene.lua:1: field.function.width: is missing; expected a number");
}

} // namespace
} // namespace scree
