// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/read_mtl.h"

#include "core/file.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace scree {
namespace {

class ReadMtl : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* name : {"wood.png", "old wood.png"})
            write_file(folder + "/" + name, "picture");
    }

    /// The materials `names` of a library with this text.
    MeshMaterials read(const std::string& text, const std::vector<MaterialUse>& uses = {{"a", 1}}) {
        write_file(folder + "/lib.mtl", text);
        return read_mtl({"lib.mtl"}, uses, folder);
    }
    MeshMaterial one(const std::string& statements) {
        return read("newmtl a\n" + statements).list.front();
    }

    test::Folder temporary;
    std::string folder = temporary.path().string();
};

TEST_F(ReadMtl, Statements) {
    const MeshMaterial red = one("  Kd 1 0.5 0.25\r\n\tKs 0.5 0.5 0.5\nNs 30\nillum 2\nNi 1.4\n");
    EXPECT_EQ(red.name, "a");
    EXPECT_EQ(red.color, Color(1, 0.5F, 0.25F));
    EXPECT_TRUE(red.coated);
    EXPECT_NEAR(red.roughness, 0.5, 1e-12); // 2 / 32 is 0.5^4
    EXPECT_EQ(red.ior, 1.4);
    EXPECT_EQ(red.transmission, 0);
    EXPECT_EQ(one("Kd 0.5\n").color, Color(0.5F));
    EXPECT_EQ(one("").color, Color(1.0F));
    EXPECT_FALSE(one("Kd 1 1 1\nKs 0 0 0\n").coated);
    EXPECT_FALSE(one("Ks 1 1 1\nillum 1\n").coated);
    EXPECT_TRUE(one("illum 2\nKs 0 0 0.1\n").coated);
    EXPECT_EQ(one("d 0.25\n").transmission, 0.75);
    EXPECT_EQ(one("Tr 0.75\n").transmission, 0.75);
    EXPECT_EQ(one("d 1\nTr 1\n").transmission, 0); // some programs write both as the same
    EXPECT_EQ(one("Tr 1\nd 1\n").transmission, 0);
    EXPECT_EQ(one("Pr 0.3\nNs 30\n").roughness, 0.3);
    EXPECT_EQ(one("Ns 30\nPr 0.3\n").roughness, 0.3);
    EXPECT_EQ(one("Pm 1\n").metallic, 1);
    EXPECT_EQ(one("Ni 0\n").ior, 1.5);
    EXPECT_EQ(one("KD 0 1 0\n").color, Color(0, 1, 0));
}

TEST_F(ReadMtl, Pictures) {
    struct Case {
        const char* value;
        const char* file;
        Imath::M33d picture_from_uv;
        bool repeats;
    };
    const std::vector<Case> cases{
        {"wood.png", "wood.png", {}, true},
        {"old wood.png", "old wood.png", {}, true},
        {".\\wood.png", "wood.png", {}, true},
        {"-clamp on wood.png", "wood.png", {}, false},
        {"-s 2 3 1 old wood.png", "old wood.png", {2, 0, 0, 0, 3, 0, 0, 0, 1}, true},
        {"-s 2 -o 0.5 0.25 wood.png", "wood.png", {2, 0, 0, 0, 1, 0, 0.5, 0.25, 1}, true},
        {"-bm 0.5 -mm 0 1 -blendu off wood.png", "wood.png", {}, true},
    };
    for (const Case& c : cases) {
        const auto picture = one(std::string("map_Kd ") + c.value + "\n").picture;
        ASSERT_TRUE(picture) << c.value;
        EXPECT_EQ(picture->problem, "") << c.value;
        EXPECT_TRUE(std::filesystem::equivalent(picture->path, folder + "/" + c.file)) << c.value;
        EXPECT_EQ(picture->picture_from_uv, c.picture_from_uv) << c.value;
        EXPECT_EQ(picture->repeats, c.repeats) << c.value;
    }
    EXPECT_EQ(one("map_Kd gone.png\n").picture->problem, "there is no file gone.png beside it");
}

TEST_F(ReadMtl, WhatIsNotReadIsNamed) {
    struct Case {
        const char* statements;
        std::vector<std::string> named;
    };
    const std::vector<Case> cases{
        {"Ka 1 1 1\nKe 0 0 0\nTf 1 1 1\nillum 2\n", {}},
        {"bump a.png\nmap_d b.png\n", {"bump of a", "map_d of a"}},
        {"Ke 1 0 0\n", {"Ke of a"}},
        {"illum 5\n", {"illum 5 of a"}},
        {"Tf 1 0.5 1\n", {"Tf of a"}},
        {"d -halo 1\n", {"d -halo of a"}},
        {"Kd 2 0 0\n", {"Kd 2 0 0 of a"}},
        {"Kd  2 2 3  # bright\n", {"Kd 2 2 3 of a"}}, // once
        {"Kd 2\n", {"Kd 2 of a"}},
        {"Tr 1.5\n", {"Tr 1.5 of a"}},
        {"Ks 0.5 0.5 0.5\n", {}},
        {"Ks 0.5 0.5 0.25\n", {"the colour of Ks of a"}},
        {"map_Kd -mm 0 2 wood.png\n", {"option -mm of map_Kd of a"}},
    };
    for (const Case& c : cases)
        EXPECT_EQ(read(std::string("newmtl a\n") + c.statements).not_read, c.named) << c.statements;
    // A value that is none is named with its line, and the rest is read.
    const MeshMaterials broken = read("newmtl a\nKd red\nNi 1.25\n");
    ASSERT_EQ(broken.not_read.size(), 1U);
    EXPECT_EQ(broken.not_read.front().rfind("line 2 (", 0), 0U) << broken.not_read.front();
    EXPECT_EQ(broken.list.front().ior, 1.25);
}

TEST_F(ReadMtl, NamesAndLibraries) {
    const std::string text = "# two\nKd 1 1 1\nnewmtl dark oak\nKd 0.25\n\nnewmtl b\nKd 0.5\n";
    const MeshMaterials both =
        read(text, {{"b", 1}, {"dark oak", 5}, {"", 0}, {"Dark_Oak", 7}, {"tin", 9}});
    ASSERT_EQ(both.list.size(), 5U);
    EXPECT_EQ(both.list[0].color, Color(0.5F));
    EXPECT_EQ(both.list[1].color, Color(0.25F));
    EXPECT_EQ(both.list[2].color, Color(0.5F)); // grey, as what has no material
    EXPECT_EQ(both.list[2].name, "");
    EXPECT_EQ(both.not_read, (std::vector<std::string>{
                                 "usemtl Dark_Oak at line 7, which no mtllib has (taken as grey; "
                                 "did you mean dark oak?)",
                                 "usemtl tin at line 9, which no mtllib has (taken as grey)"}));

    write_file(folder + "/my lib.mtl", "newmtl a\nKd 0.75\n");
    EXPECT_EQ(read_mtl({"my lib.mtl"}, {{"a", 1}}, folder).list[0].color, Color(0.75F));
    EXPECT_EQ(read_mtl({"lib.mtl ./lib.mtl"}, {{"b", 1}}, folder).list[0].color, Color(0.5F));
    EXPECT_EQ(read_mtl({"lib.mtl", "my lib.mtl"}, {{"a", 1}}, folder).list[0].color, Color(0.75F));

    const MeshMaterials missing = read_mtl({"gone.mtl"}, {{"a", 1}}, folder);
    EXPECT_TRUE(missing.list.empty());
    EXPECT_EQ(missing.problem, "there is no file gone.mtl beside it");
    EXPECT_EQ(read_mtl({}, {{"a", 1}}, folder).problem,
              "it names some, but no library of them (mtllib)");
    EXPECT_EQ(read_mtl({}, {}, folder).problem, "");
}

} // namespace
} // namespace scree
