// SPDX-License-Identifier: GPL-3.0-or-later
// STL files, text and binary, as programs write them.
#include "tests/support/mesh_bytes.h"
#include "tests/support/mesh_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scree {
namespace {

using namespace tests;

std::string facet(const std::vector<std::string>& corners) {
    std::string out = " facet normal 0 1 0\n  outer loop\n";
    for (const std::string& corner : corners)
        out += "   vertex " + corner + "\n";
    return out + "  endloop\n endfacet\n";
}

// A unit square in the plane y = 0.
std::string tile() {
    return "solid tile\n" + facet({"0 0 0", "0 0 1", "1 0 0"}) +
           facet({"1 0 0", "0 0 1", "1 0 1"}) + "endsolid tile\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
    return text;
}

TEST(StlFile, TextsAsProgramsWriteThem) {
    std::string half = tile();
    half.insert(half.find(" facet", 20), "endsolid\n\nsolid\n"); // a second solid without a name
    const std::vector<std::pair<std::string, std::string>> tiles{
        {"plain", tile()},
        {"blank first", " " + tile()},
        {"lines first", "\n\r\n\t\n" + tile()},
        {"byte order mark", "\xef\xbb\xbf" + tile()},
        {"capitals", upper(tile())},
        {"Solid", replaced(tile(), "solid", "Solid")},
        {"CR LF", replaced(tile(), "\n", "\r\n")},
        {"CR", replaced(tile(), "\n", "\r")},
        {"tabs", replaced(tile(), " ", "\t")},
        {"no indents", replaced(replaced(tile(), "\n  ", "\n"), "\n ", "\n")},
        {"empty lines", replaced(tile(), "\n", "\n\n")},
        {"several words on a line", replaced(tile(), "0\n  outer loop\n", "0 outer loop ")},
        {"no name", replaced(tile(), " tile", "")},
        {"name of several words", replaced(tile(), "tile", "tile of 2 solid parts facet")},
        {"name that is not ASCII", replaced(tile(), "tile", "T\xc3\xbc\xffr")},
        {"no line end at the end", tile().substr(0, tile().size() - 1)},
        {"zero bytes at the end", tile() + std::string(5, '\0')},
        {"normals that are not numbers", replaced(tile(), "normal 0 1 0", "normal nan -nan inf")},
        {"no normals", replaced(tile(), " normal 0 1 0", "")},
        {"exponents",
         replaced(replaced(tile(), "vertex 1 ", "vertex +1.0E+00 "), " 0\n", " -0.0e+000\n")},
        {"two solids", half},
        {"without solid", tile().substr(11)},
        {"one facet of four corners",
         "solid\n" + facet({"0 0 0", "0 0 1", "1 0 1", "1 0 0"}) + "endsolid\n"},
    };
    for (const auto& [name, text] : tiles) {
        EXPECT_EQ(file_facts("a.stl", text), "2 triangles") << name;
        EXPECT_NEAR(file_area("a.stl", text), 1, 1e-9) << name;
        EXPECT_EQ(read_file_mesh_bytes("a.stl", text).positions.size(), 4U) << name;
    }
}

TEST(StlFile, TextsThatAreRefusedOrTold) {
    const std::vector<std::pair<std::string, std::string>> rows{
        {replaced(tile(), "vertex 1 0 1", "vertex 1 0 1,5"),
         "line 13: \"1,5\" is not a number; expected a decimal point, and no commas between "
         "thousands"},
        {replaced(tile(), "vertex 1 0 1", "vertex 1 0"),
         "line 13: vertex has 2 numbers; expected 3"},
        {replaced(tile(), "vertex 1 0 1", "vertex 1\n0"),
         "line 13: vertex has 2 numbers; expected 3"},
        {replaced(tile(), "vertex 1 0 1", "vertex 1 0 nan"), "line 13: \"nan\" is not a number"},
        {replaced(tile(), "vertex 1 0 1", "vertx 1 0 1"),
         "line 13: \"vertx\" is not expected here; expected vertex or endloop"},
        {replaced(tile(), "   vertex 1 0 1\n", ""),
         "line 9: a facet has 2 corners; expected at least 3"},
        {replaced(tile(), "vertex 1 0 1", "vertex 1 0 1 0"),
         "line 13: \"0\" is not expected here; expected vertex or endloop"},
        {replaced(tile(), "outer loop", "loop"),
         "line 3: \"loop\" is not expected here; expected outer loop"},
        {replaced(tile(), " endfacet\n", ""),
         "line 8: \"facet\" is not expected here; expected endfacet"},
        {replaced(tile(), " facet normal", " fact normal"),
         "line 2: \"fact\" is not expected here; expected facet, solid or endsolid"},
        {tile().substr(0, tile().rfind("  endloop")), "it ends too early, within a facet"},
        {"solid\nendsolid\n", "it has no triangles"},
        {"# a comment\n" + tile(),
         "line 1: \"#\" is not expected here; expected facet, solid or endsolid"},
    };
    for (const auto& [text, problem] : rows)
        EXPECT_EQ(file_problem("a.stl", text), "a.stl: " + problem);
    EXPECT_EQ(file_facts("a.stl", replaced(tile(), "endsolid tile\n", "")),
              "2 triangles; it ends without \"endsolid\": is it complete?");
}

TEST(StlFile, BinaryCountsAgreeWithTheSize) {
    for (const std::string title : {"", "solid", "solid made by a program", "SOLID x", "facet"}) {
        const std::string whole = stl_binary(title);
        EXPECT_EQ(file_facts("a.stl", whole), "4 triangles") << title;
        EXPECT_NEAR(file_area("a.stl", whole), 1.5 + std::sqrt(0.75), 1e-6) << title;
        EXPECT_EQ(file_problem("a.stl", whole.substr(0, whole.size() - 1)),
                  "a.stl: it ends too early: its header promises 4 triangles, there is room for 3")
            << title;
        EXPECT_EQ(file_problem("a.stl", whole + std::string(120, 'x')),
                  "a.stl: it goes on after the 4 triangles that its header promises: there is room "
                  "for 6")
            << title;
        EXPECT_EQ(file_facts("a.stl", whole + std::string(3, '\0')),
                  "4 triangles; not read: 3 bytes at its end")
            << title;
    }
    EXPECT_EQ(file_problem("a.stl", std::string(6, '\1')),
              "a.stl: it has 6 bytes; a binary file has at least 84");
}

TEST(StlFile, TextsKeepTheDigitsOfSurveys) {
    const FileMesh mesh = read_file_mesh_bytes(
        "a.stl", "solid\n" +
                     facet({"7502223.336235 12 4485513.721904", "7502223.836235 12 4485513.721904",
                            "7502223.336235 12 4485514.221904"}) +
                     "endsolid\n");
    EXPECT_NEAR(mesh.positions[1].x - mesh.positions[0].x, 0.5, 1e-8);
    EXPECT_NEAR(mesh.positions[2].z - mesh.positions[0].z, 0.5, 1e-8);
}

} // namespace
} // namespace scree
