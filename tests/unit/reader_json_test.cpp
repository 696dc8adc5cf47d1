// SPDX-License-Identifier: GPL-3.0-or-later
// Round trips through JSON, and deterministic mutations, which may fail only with an Error.
#include "core/file.h"
#include "scenes/reader/json.h"
#include "scenes/reader/lua_lexer.h"
#include "scenes/reader/scene.h"
#include "scenes/reader/script.h"
#include "scenes/reader/source_map.h"
#include "session/catalog.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <random>

namespace scree {
namespace {

namespace fs = std::filesystem;

const char* const script =
    R"(local wood = material.plastic { color = procedural.checker { size = 0.1 },
  roughness = 0.3 }
local box = mesh.box {}
local objects = {}
for i = 1, 5 do
  objects[i] = object { shape = box, material = wood, position = { i, 0.5, -i * 1e-3 } }
end
return scene {
  film = { width = 64, height = 48 },
  camera = camera.perspective { from = { 0, 1, 3 }, at = { 0, 0, 0 }, fov = 35 },
  lights = { light.sky { color = { 1, 1, 1 } }, light.sun { direction = { 1, 2, 1 } } },
  objects = objects,
}
)";

std::string temporary(const std::string& name) {
    static const test::Folder folder;
    return folder.file(name);
}

const Catalog& catalog() {
    static const Catalog standard = standard_catalog();
    return standard;
}

ScriptOptions script_options() { return {.families = catalog().constructor_families()}; }

SceneDraft resolved(const DescriptionNode& root) { return resolve(root, "x", catalog()); }

DescriptionNode described() {
    const std::string file = temporary("scene.lua");
    write_file(file, script);
    DescriptionNode node = run_script(file, script_options());
    fs::remove(file);
    return node;
}

TEST(ReaderJson, ReadsBackToTheSame) {
    const DescriptionNode first = described();
    for (const bool indent : {true, false}) {
        const std::string json = to_json(*first, {.locations = true, .indent = indent});
        const DescriptionNode second = description_from_json(json, "other.json");
        EXPECT_EQ(to_json(*second, {.locations = true, .indent = indent}), json);
        EXPECT_EQ(second->where.file, first->where.file);
        EXPECT_EQ(second->where.line, 8);
        EXPECT_EQ(resolved(second).scene.hash, resolved(first).scene.hash);
        EXPECT_EQ(resolved(second).items.size(), 5U);
    }
}

TEST(ReaderJson, OddValuesReadBack) {
    const std::string json =
        R"({"$kind": "scene", "$$odd": 1, "a": {"$number": "nan"},)"
        R"( "b": {"$number": "-inf"}, "c": [], "d": {}, "e": 1.0, "f": "ü\n"})";
    const JsonStyle style{.locations = false, .indent = false};
    EXPECT_EQ(to_json(*description_from_json(json, "a.json"), style), json);
}

TEST(ReaderJson, HashIgnoresLineNumbers) {
    const std::string file = temporary("moved.lua");
    write_file(file, "-- a comment\n\n" + std::string(script));
    EXPECT_EQ(resolved(run_script(file, script_options())).scene.hash,
              resolved(described()).scene.hash);
    fs::remove(file);
}

TEST(ReaderJson, ResolveMakesSharedObjectsOnce) {
    const SceneDraft draft = resolved(described());
    ASSERT_EQ(draft.items.size(), 5U);
    const Prototype first = draft.items[0]->bake({}, 0).prototypes[0];
    const Prototype last = draft.items[4]->bake({}, 4).prototypes[0];
    EXPECT_EQ(first.mesh(), last.mesh());
    ASSERT_EQ(first.materials.size(), 1U);
    EXPECT_EQ(first.materials, last.materials);
    EXPECT_TRUE(draft.scene.camera);
    EXPECT_EQ(draft.scene.lights.size(), 2U);
}

// One to four small mutations: a byte changed, removed or doubled, or a piece moved.
std::string mutated(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return random() % std::max<std::size_t>(n, 1); };
    const std::string bytes = "{}[]\",:=()-.0129eE$\\\n\xff\x00azk";
    for (std::size_t changes = 1 + below(4); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = below(text.size());
        switch (below(4)) {
        case 0:
            text[at] = bytes[below(bytes.size())];
            break;
        case 1:
            text.erase(at, 1 + below(8));
            break;
        case 2:
            text.insert(at, 1, bytes[below(bytes.size())]);
            break;
        default:
            text.insert(below(text.size()), text.substr(at, 1 + below(30)));
        }
    }
    return text;
}

template <class Body>
void error_or_success(const Body& body) {
    try {
        body();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()), "");
    }
}

TEST(ReaderMutation, Json) {
    const std::string json = to_json(*described());
    std::mt19937 random(1);
    for (int i = 0; i < 3000; ++i) {
        const std::string text = mutated(json, random);
        error_or_success([&] { resolved(description_from_json(text, "m.json")); });
    }
}

TEST(ReaderMutation, SourceMap) {
    std::mt19937 random(2);
    for (int i = 0; i < 3000; ++i) {
        const std::string text = mutated(script, random);
        const SourceMap map(text);
        for (const TableSource& table : map.tables())
            map.find(table.callee, table.line, {"size"});
    }
}

TEST(ReaderMutation, Script) {
    const std::string file = temporary("mutated.lua");
    std::mt19937 random(3);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(8);
    for (int i = 0; i < 400 && std::chrono::steady_clock::now() < end; ++i) {
        write_file(file, mutated(script, random));
        error_or_success([&] {
            ScriptOptions options = script_options();
            options.limits = {.seconds = 0.2, .memory = std::size_t{32} << 20};
            resolved(run_script(file, options));
        });
    }
    fs::remove(file);
}

} // namespace
} // namespace scree
