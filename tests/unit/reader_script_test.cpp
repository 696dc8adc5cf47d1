// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts: their results, the lines of their fields, and that they cannot escape the sandbox.
#include "scenes/reader/child_process.h"
#include "scenes/reader/confinement.h"
#include "scenes/reader/json.h"
#include "scenes/reader/scene.h"
#include "scenes/reader/script.h"
#include "scenes/reader/source_map.h"

#include "core/file.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <linux/landlock.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace scree {
namespace {

namespace fs = std::filesystem;
using Table = Description::Table;
using List = Description::List;

class ReaderScript : public testing::Test {
  protected:
    std::string write(const std::string& name, const std::string& text) {
        return folder_.write(name, text);
    }

    DescriptionNode run(const std::string& text, ScriptOptions options = {}) {
        options.families = {"camera", "light", "material", "mesh"};
        if (!options.print)
            options.print = [this](std::string_view said) { printed_ += said; };
        return run_script(write("scene.lua", text), options);
    }

    std::string error_of(const std::string& text) {
        ScriptOptions options;
        options.limits = {.seconds = 1, .memory = std::size_t{32} << 20};
        try {
            run(text, options);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }

    static const Description::Item& field(const DescriptionNode& node, const std::string& name) {
        return std::get<Table>(node->data).at(name);
    }
    static const Description::Item& item(const DescriptionNode& node, std::size_t index) {
        return std::get<List>(node->data).at(index);
    }

    test::Folder folder_;
    std::string printed_;
};

TEST_F(ReaderScript, FieldsKnowTheirLines) {
    const DescriptionNode scene = run(R"(local name = "--[[ not a comment { "
--[==[ comment {
]==]
return scene {
  film = { width = 3,
           height = 4 },
  lights = {
    light.sky { color = { 1, 2,
                          3 } },
    light.sun { angle = (function() local a, b = 1, 2; return { x = a, y = b } end)().x,
                strength = 2 },
  },
  ["objects"] = {},
})");
    EXPECT_EQ(scene->where.line, 4);
    EXPECT_EQ(field(scene, "film").line, 5);
    EXPECT_EQ(field(field(scene, "film").value, "height").line, 6);
    EXPECT_EQ(field(scene, "objects").line, 13);
    const DescriptionNode lights = field(scene, "lights").value;
    EXPECT_EQ(item(lights, 0).value->kind, "light.sky");
    EXPECT_EQ(item(lights, 0).value->where.line, 8);
    EXPECT_EQ(item(field(item(lights, 0).value, "color").value, 1).line, 8);
    EXPECT_EQ(item(field(item(lights, 0).value, "color").value, 2).line, 9);
    EXPECT_EQ(field(item(lights, 1).value, "strength").line, 11);
}

TEST_F(ReaderScript, SharedTablesStayOneNode) {
    const DescriptionNode scene = run(R"(local box = mesh.box {}
return scene { objects = { object { shape = box }, object { shape = box },
                           object { shape = mesh.box {} } } })");
    const DescriptionNode objects = field(scene, "objects").value;
    const auto shape = [&](std::size_t i) { return field(item(objects, i).value, "shape").value; };
    EXPECT_EQ(shape(0), shape(1));
    EXPECT_NE(shape(0), shape(2));
    EXPECT_EQ(field(item(objects, 1).value, "shape").line, 2);
    EXPECT_EQ(shape(1)->where.line, 1);
}

TEST_F(ReaderScript, SameScriptSameDescription) {
    const std::string script = R"(local all, names = {}, {}
for i = 1, 50 do all["name" .. math.random(1e9)] = math.random() end
for name, value in pairs(all) do names[#names + 1] = name .. tostring(value) .. tostring({}) end
local first = next(all)
table.sort(names, function(a, b) return #a < #b end)
return scene { film = names, lights = { first } })";
    const std::string first = to_json(*run(script));
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(to_json(*run(script)), first);
}

TEST_F(ReaderScript, ArgumentsAreTypedByTheirDefaults) {
    ScriptOptions options;
    options.overrides = {{"seed", "9"}, {"size", "0.5"}, {"name", "12"}, {"night", "true"}};
    const DescriptionNode value =
        run(R"(return scene { seed = arg("seed", 7), size = arg("size", 1),
  name = arg("name", "x"), night = arg("night", false), other = arg("other", 3) })",
            options);
    EXPECT_EQ(std::get<std::int64_t>(field(value, "seed").value->data), 9);
    EXPECT_EQ(std::get<double>(field(value, "size").value->data), 0.5);
    EXPECT_EQ(std::get<std::string>(field(value, "name").value->data), "12");
    EXPECT_EQ(std::get<bool>(field(value, "night").value->data), true);
    EXPECT_EQ(std::get<std::int64_t>(field(value, "other").value->data), 3);
}

TEST_F(ReaderScript, HelpersConvert) {
    const DescriptionNode value =
        run(R"(return scene { mm = mm(25), cm = cm(25), deg = deg(90), c = srgb("#ff0080") })");
    EXPECT_EQ(std::get<double>(field(value, "mm").value->data), 0.025);
    EXPECT_EQ(std::get<double>(field(value, "cm").value->data), 0.25);
    EXPECT_EQ(std::get<double>(field(value, "deg").value->data), 90.0);
    const DescriptionNode color = field(value, "c").value;
    EXPECT_EQ(std::get<double>(item(color, 0).value->data), 1.0);
    EXPECT_EQ(std::get<double>(item(color, 1).value->data), 0.0);
    EXPECT_NEAR(std::get<double>(item(color, 2).value->data), 0.2158605, 1e-6);
}

TEST_F(ReaderScript, IncludeGivesTheOtherScriptsValueOnce) {
    fs::create_directories(folder_.path() / "parts");
    write("parts/box.lua", "print(\"read\")\nreturn mesh.box { size = include(\"size.lua\") }");
    write("parts/size.lua", "return 3");
    const DescriptionNode value =
        run("return scene { a = include(\"parts/box.lua\"), b = include(\"parts/box.lua\") }");
    EXPECT_EQ(field(value, "a").value, field(value, "b").value);
    EXPECT_EQ(field(value, "a").value->where.file, folder_.file("parts/box.lua"));
    EXPECT_EQ(field(value, "a").value->where.line, 2);
    EXPECT_EQ(printed_, "read\n");
}

TEST_F(ReaderScript, IncludesComeFromTheScenesFolderOrWhereTheUserAllows) {
    const test::Folder far;
    far.write("size.lua", "return 3");
    fs::create_symlink(far.file("size.lua"), folder_.file("link.lua"));
    const std::string outside = ": lies outside of the scene's folder\n  --allow-read ";
    EXPECT_NE(error_of("return include(\"" + far.file("size.lua") + "\")").find(outside),
              std::string::npos);
    EXPECT_NE(error_of("return include(\"link.lua\")").find(outside), std::string::npos);
    ScriptOptions options;
    options.readable_folders = {far.path().string()};
    EXPECT_EQ(std::get<std::int64_t>(run("return include(\"link.lua\")", options)->data), 3);
}

// The second wall, behind the language: a process that was taken over can do nothing either.
TEST_F(ReaderScript, TheProcessOfAScriptCanOnlyRead) {
    if (syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) < 1)
        GTEST_SKIP() << "this kernel has no Landlock";
    const std::string script = write("scene.lua", "return 1");
    const test::Folder far;
    const std::string secret = far.write("secret.txt", "secret");
    std::string answers;
    run_in_child(
        {.cpu_seconds = 10, .wall_seconds = 60, .memory = std::size_t{1} << 30},
        [&](const Channel& channel) {
            confine_process(script, {folder_.path().string()});
            const auto can = [&](bool yes) { channel.send(yes ? 'y' : 'n', {}); };
            can(open(script.c_str(), O_RDONLY) >= 0);
            can(open(secret.c_str(), O_RDONLY) >= 0);
            can(open("/etc/passwd", O_RDONLY) >= 0);
            can(open(folder_.file("new.txt").c_str(), O_WRONLY | O_CREAT, 0600) >= 0);
            can(unlink(script.c_str()) == 0);
            can(truncate(script.c_str(), 0) == 0);
            can(syscall(SYS_tgkill, getppid(), getppid(), 0) == 0);
            can(socket(AF_INET, SOCK_STREAM, 0) >= 0);
            can(kill(getppid(), 0) == 0);
            can(fork() >= 0);
            can(execl("/bin/true", "true", nullptr) == 0);
        },
        [&](char answer, const std::string& /*bytes*/) { answers += answer; });
    EXPECT_EQ(answers, "ynnnnnnnnnn");
    EXPECT_TRUE(fs::exists(script));
}

TEST_F(ReaderScript, NothingLeadsOutOfTheSandbox) {
    for (const char* script : {"os.execute(\"true\")",
                               "io.open(\"x\", \"w\")",
                               "_G.os.exit()",
                               "load(\"return 1\")()",
                               "loadstring(\"x\")",
                               "dofile(\"/etc/passwd\")",
                               "require(\"os\")",
                               "package.loadlib()",
                               "debug.getregistry()",
                               "collectgarbage()",
                               "string.dump(print)",
                               "(\"\").dump(print)",
                               "getmetatable(\"\").__index = {}",
                               "rawget(_G, \"os\").exit()",
                               "_ENV.io.open()",
                               "setmetatable(_G, nil)",
                               "setmetatable(mesh, nil)",
                               "mesh.box.x = 1",
                               "scree_constructor()",
                               "setmetatable({}, { __gc = print })",
                               "getmetatable(mesh.box {}).x = 1",
                               "coroutine.wrap(function() os.exit() end)()",
                               "rawset(string, \"x\", 1).dump()"})
        EXPECT_NE(error_of(script), "") << script;
}

TEST_F(ReaderScript, LimitsCannotBeCaught) {
    const char* time = "ran for more than 1 s";
    const char* memory = "more than 32 MiB";
    EXPECT_NE(error_of("while true do pcall(function() while true do end end) end").find(time),
              std::string::npos);
    EXPECT_NE(
        error_of("while true do xpcall(error, function() while true do end end) end").find(time),
        std::string::npos);
    EXPECT_NE(
        error_of("local t = setmetatable({}, { __close = function() while true do end end })\n"
                 "do local x <close> = t end")
            .find(time),
        std::string::npos);
    EXPECT_NE(error_of("while true do coroutine.wrap(function() local x = 1 end)() end").find(time),
              std::string::npos);
    EXPECT_NE(error_of("local t = {} while true do pcall(function() t[#t + 1] = {} end) end")
                  .find(memory),
              std::string::npos);
    EXPECT_NE(error_of("local t = {} local function f() t[#t + 1] = coroutine.create(f) end\n"
                       "while true do f() end")
                  .find(memory),
              std::string::npos);
}

TEST(SourceMap, FindsTheTableOfACall) {
    const SourceMap map("local a = mesh.box { size = 1 } local b = mesh.box { depth = 2,\n"
                        " width = 3 }\nlocal m = mesh.box\nlocal c = m {\n size = 4 }\n"
                        "local d = mesh.box({ size = {\n 5 } })");
    EXPECT_EQ(map.find("mesh.box", 1, {"size"})->named("size")->line, 1);
    EXPECT_EQ(map.find("mesh.box", 1, {"depth", "width"})->named("width")->line, 2);
    EXPECT_EQ(map.find("mesh.box", 4, {"size"})->named("size")->line, 5);
    const TableSource* d = map.find("mesh.box", 6, {"size"});
    EXPECT_EQ(map.at(d->named("size")->table)->positional(0)->line, 7);
    EXPECT_EQ(map.find("mesh.box", 3, {}), nullptr);
}

// Quadratic work here once took minutes for a script that a second can run.
TEST_F(ReaderScript, HugeTablesAndLinesAreReadInLinearTime) {
    std::string rows;
    std::string line;
    for (int i = 0; i < 100'000; ++i) {
        rows += "{ x = " + std::to_string(i) + " },\n";
        line += "mesh.box { size = 1 }, ";
    }
    const DescriptionNode value =
        run("return scene { rows = {\n" + rows + "},\n one = { " + line + " } }");
    const DescriptionNode list = field(value, "rows").value;
    EXPECT_EQ(std::get<List>(list->data).size(), 100'000U);
    EXPECT_EQ(field(item(list, 99'999).value, "x").line, 100'001);
    EXPECT_EQ(std::get<List>(field(value, "one").value->data).size(), 100'000U);
}

} // namespace
} // namespace scree
