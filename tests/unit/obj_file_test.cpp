// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ files as programs write them: each is read as what it says, or refused with the line.
#include "tests/support/mesh_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree {
namespace {

using namespace tests;

// A unit square in the plane y = 0, as two triangles.
const std::string v = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\n";
const std::string f = "f 1 2 3\nf 1 3 4\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

TEST(ObjFile, SquaresAsProgramsWriteThem) {
    const std::vector<std::pair<std::string, std::string>> squares{
        {"plain", v + f},
        {"tabs", with(v + f, " ", "\t")},
        {"several blanks", with(v + f, " ", "   ")},
        {"blanks at the ends", with(v + f, "\n", " \t \n \t")},
        {"CR LF", with(v + f, "\n", "\r\n")},
        {"CR", with(v + f, "\n", "\r")},
        {"empty lines", with(v + f, "\n", "\n\n\r\n")},
        {"no line end at the end", v + f.substr(0, f.size() - 1)},
        {"byte order mark", "\xef\xbb\xbf" + v + f},
        {"zero bytes at the end", v + f + std::string(7, '\0')},
        {"comments", "# a v 1 2\n" + with(v, "\n", " # corner\n") + "f 1 2 3 # a \\\nf 1 3 4 #\n"},
        {"capital E", with(v, "1", "1.0E+00") + f},
        {"small e", with(v, "1", "10e-1") + f},
        {"signs", with(v, "1", "+1.") + f},
        {"no nought before the point", with(v, "1", "+.1e1") + f},
        {"tiny numbers", with(v, " 0", " 1e-400") + f},
        {"negative indices", v + "f -4 -3 -2\nf -4 -2 -1\n"},
        {"negative indices between vertices", "v 0 0 0\nv 1 0 0\nv 1 0 1\nf -3 -2 -1\nv 0 0 1\n"
                                              "f -4 -2 -1\n"},
        {"faces first", f + v},
        {"weights", with(v, "\n", " 1.0\n") + f},
        {"one face", v + "f 1 2 3 4\n"},
        {"older name of a face", v + "fo 1 2 3 4\n"},
        {"first corner again at the end", v + "f 1 2 3 4 1\n"},
        {"every corner twice", v + "f 1 1 2 2 3 3 4 4\n"},
        {"empty slots", v + "f 1// 2// 3//\nf 1/ 3// 4\n"},
        {"texture coordinates of one number", v + "vt 0\nf 1/1/ 2/1/ 3/1/ 4/1\n"},
        {"texture coordinates of three", v + "vt 0 1 0\nf 1/1/ 2/1/ 3/1/ 4/1\n"},
        {"normals", v + "vn 0 1 0\nf 1//1 2//-1 3//1 4//1\n"},
        {"continued", v + "f 1 2 \\\n 3 4\n"},
        {"continued often", "v 0\\\n0 0\n" + v.substr(8) + "f \\\r\n1 \\  \r\n2\\\n3 \\\n4\\"},
        {"names that end in a backslash", "usemtl wood\\dark\\\n" + v + "g a\\\n" + f},
        {"names like statements", v + "g f 1 2 3 faces\no v 1\nusemtl f\n" + f},
        {"groups and materials", "mtllib not there.mtl\no s\ns off\nmg 0\nusemap a\n" + v + f}};
    for (const auto& [name, text] : squares) {
        EXPECT_EQ(file_facts("a.obj", text), "2 triangles") << name;
        EXPECT_NEAR(file_area("a.obj", text), 1, 1e-9) << name;
    }
}

TEST(ObjFile, WhatIsNotReadIsNamed) {
    const std::vector<std::pair<std::string, std::string>> rows{
        {v + "l 1 3\np 1\nl 1 2\n" + f, "not read: lines (line 5 and 1 more), points (line 6)"},
        {v + "curv 0 1 1 2\n" + f, "not read: curves (line 5)"},
        {with(v, "\n", " 1 .5 .2\n") + f, "not read: vertex colours (line 1 and 3 more)"},
        {with(v, "\n", " 1 .5 .2 1\n") + f, "not read: vertex colours (line 1 and 3 more)"},
        {v + "volume 3\n" + f, "not read: unknown statements (line 5)"},
        {v + "vt 0 0\nf 1/1 2/1 3/1\nf 1 3 4\n",
         "its texture coordinates are not read, since faces lack them (line 7)"},
        {v + "vn 0 1 0\nf 1 2 3\nf 1//1 3//1 4\n",
         "its normals are not read, since faces lack them (line 6 and 1 more)"},
        {v + "vn 0 0 0\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n",
         "its normals are not read, since one is 0 or not a number"},
        {v + "vt nan 0\nf 1/1 2/1 3/1\nf 1/1 3/1 4/1\n",
         "its texture coordinates are not read, since one is not a number"},
    };
    for (const auto& [text, warning] : rows) {
        EXPECT_EQ(file_facts("a.obj", text), "2 triangles; " + warning);
        EXPECT_NEAR(file_area("a.obj", text), 1, 1e-9) << warning;
    }
    EXPECT_EQ(file_problem("a.obj", v + "l 1 2 3 4 1\np 1\n"),
              "a.obj: it has no triangles; not read: lines (line 5), points (line 6)");
}

TEST(ObjFile, RefusedWithTheLine) {
    const std::string commas = "; expected a decimal point, and no commas between thousands";
    const std::vector<std::pair<std::string, std::string>> rows{
        {with(v, "v 1 0 0", "v 1,0 0 0") + f, "line 2: \"1,0\" is not a number" + commas},
        {with(v, "v 1 0 0", " v\t1,5\t0\t0") + f, "line 2: \"1,5\" is not a number" + commas},
        {with(v, "v 1 0 0", "v 1 0 1,000") + f, "line 2: \"1,000\" is not a number" + commas},
        {with(v, "v 1 0 0", "v 1 0 0x1") + f, "line 2: \"0x1\" is not a number"},
        {with(v, "v 1 0 0", "v 1 0 1d0") + f, "line 2: \"1d0\" is not a number"},
        {with(v, "v 1 0 0", "v 1 0 +-1") + f, "line 2: \"+-1\" is not a number"},
        {with(v, "v 1 0 0", "v nan 0 0") + f, "line 2: \"nan\" is not a number"},
        {with(v, "v 1 0 0", "v 1 0 1e999") + f, "line 2: \"1e999\" is not a number"},
        {with(v, "v 1 0 0", "v 1 0") + f,
         "line 2: a vertex has 2 numbers; expected x, y, z, perhaps with a weight or a colour"},
        {with(v, "v 1 0 0", "v") + f,
         "line 2: a vertex has 0 numbers; expected x, y, z, perhaps with a weight or a colour"},
        {with(v, "v 1 0 0", "v 1 0 0 1 2") + f,
         "line 2: a vertex has 5 numbers; expected x, y, z, perhaps with a weight or a colour"},
        {with(v, "v 1 0 0", "v 1 0 0 red") + f, "line 2: \"red\" is not a number"},
        {v + "vt 0,5 0\nvt 1 1\n" + f, "line 5: \"0,5\" is not a number" + commas},
        {v + "vt\n" + f, "line 5: a texture coordinate has 0 numbers; expected u, v"},
        {v + "vt a b\n" + f, "line 5: \"a\" is not a number"},
        {v + "vn 0 up 0\n" + f, "line 5: \"up\" is not a number"},
        {v + "vn 0 1\n" + f, "line 5: a normal has 2 numbers; expected x, y, z"},
        {v + "f 1 2 3\nf 1 3 9\n", "line 6: a face names vertex 9 of 4"},
        {v + "f 1 2 3\nf -5 -2 -1\n", "line 6: a face names vertex -5 of 4"},
        {v + "f 0 1 2\n", "line 5: a face names vertex 0; the first is 1"},
        {v + "vt 0 0\nf 1/1 2/1 3/2\n", "line 6: a face names texture coordinate 2 of 1"},
        {v + "vn 0 1 0\nf 1//1 2//1 3//7\n", "line 6: a face names normal 7 of 1"},
        {v + "f 1//0 2//1 3//1\n", "line 5: a face names normal 0; the first is 1"},
        {v + "f 1 2 99999999999\n", "line 5: a face names vertex 99999999999 of 4"},
        {v + "f 1 2\n", "line 5: a face has 2 corners; expected at least 3"},
        {v + "f\n", "line 5: a face has 0 corners; expected at least 3"},
        {v + "f 1 2 x\n", "line 5: \"x\" is not a corner of a face; expected whole numbers"},
        {v + "f 1 2 3.5\n", "line 5: \"3.5\" is not a corner of a face; expected whole numbers"},
        {v + "f 1 2 /3\n", "line 5: \"/3\" is not a corner of a face; expected whole numbers"},
        {v + "f 1,0 2 3\n",
         "line 5: \"1,0\" is not a corner of a face; expected whole numbers without commas"},
        {v + "f 1/1/1/1 2 3\n",
         "line 5: \"1/1/1/1\" is not a corner; expected vertex/texture coordinate/normal"},
        {v + "f 1 2 \\\n x\n", "line 5: \"x\" is not a corner of a face; expected whole numbers"},
        {with(v, "\n", "\r") + "f 1 3 9\r", "line 5: a face names vertex 9 of 4"},
        {v + f + "bzp 1 2 3 4\n",
         "line 7: free-form surfaces (bzp) are not read; export them as polygons"},
        {v + f + "surf 0 1 0 1 1 2 3 4\n",
         "line 7: free-form surfaces (surf) are not read; export them as polygons"},
        {v + "call more.obj\n" + f,
         "line 5: other files (call) are not read; put everything into one file"},
    };
    for (const auto& [text, problem] : rows)
        EXPECT_EQ(file_problem("a.obj", text), "a.obj: " + problem);
    EXPECT_EQ(file_problem("a.obj", std::string("\xff\xfev\0", 4)),
              "a.obj: it is UTF-16 text; expected ASCII or UTF-8");
}

TEST(ObjFile, PartsAreCountedInSixteenBits) {
    std::string text = v;
    for (std::size_t i = 0; i < Mesh::most_parts; ++i)
        text += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
    EXPECT_EQ(read_file_mesh_bytes("a.obj", text).parts.back(), Mesh::most_parts - 1);
    EXPECT_NE(file_problem("a.obj", text + "usemtl more\nf 1 2 3\n")
                  .find("it uses more than 65536 materials"),
              std::string::npos);
}

TEST(ObjFile, ConcaveFacesHaveTheirArea) {
    // The plan of a room with a niche: 8 x 6 less 5 x 2 and 1 x 1.
    const std::string plan = "v 0 0 0\nv 8 0 0\nv 8 0 2\nv 3 0 2\nv 3 0 4\nv 8 0 4\nv 8 0 6\n"
                             "v 1 0 6\nv 1 0 5\nv 0 0 5\nv 0 0 3\nf 1 2 3 4 5 6 7 8 9 10 11\n";
    EXPECT_EQ(file_facts("a.obj", plan), "9 triangles");
    EXPECT_NEAR(file_area("a.obj", plan), 37, 1e-5);
    EXPECT_EQ(file_facts("a.obj", v + "f 1 3 2 4\n"),
              "1 triangles; 1 of its faces cross themselves, the first in line 5");
}

TEST(ObjFile, NormalsAndTextureCoordinatesBelongToCorners) {
    const FileMesh mesh = read_file_mesh_bytes(
        "a.obj", v + "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 1 0\nvn 0 2 0\nf 1/1/1 2/2/1 3/3/1\n"
                     "f 1/1/1 3/3/1 4/2/2\n");
    ASSERT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.uvs[3], Vec2f(1, 0));
    EXPECT_EQ(mesh.normals[3], Vec3(0, 1, 0));
    // A corner with other texture coordinates is a vertex of its own.
    EXPECT_EQ(read_file_mesh_bytes("a.obj", v + "vt 0 0\nvt 1 0\nf 1/1 2/1 3/1\nf 1/2 3/1 4/1\n")
                  .positions.size(),
              5U);
}

TEST(ObjFile, KeepsTheDigitsOfSurveys) {
    const FileMesh mesh =
        read_file_mesh_bytes("a.obj", "v 7502223.336235 12 4485513.721904\nv 7502223.836235 12 "
                                      "4485513.721904\nv 7502223.336235 12 4485514.221904\nf 1 2 "
                                      "3\n");
    EXPECT_NEAR(mesh.positions[1].x - mesh.positions[0].x, 0.5, 1e-8);
    EXPECT_NEAR(mesh.positions[2].z - mesh.positions[0].z, 0.5, 1e-8);
}

} // namespace
} // namespace scree
