// SPDX-License-Identifier: GPL-3.0-or-later
// PLY files as programs write them: each is read as what its header says, or refused.
#include "tests/support/mesh_bytes.h"
#include "tests/support/mesh_text.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using namespace tests;

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string corners = "property list uchar int vertex_indices\n";
const std::string square = "0 0 0\n0 0 1\n1 0 1\n1 0 0\n";

// A text file: the number of vertices and their properties, other elements, the rows.
std::string ascii(int vertices, const std::string& properties, const std::string& elements,
                  const std::string& rows) {
    return fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n{}{}end_header\n{}", vertices,
                       properties, elements, rows);
}

std::string faces(int count, const std::string& properties = corners) {
    return fmt::format("element face {}\n{}", count, properties);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

TEST(PlyFile, SquaresAsProgramsWriteThem) {
    const std::string plain = ascii(4, xyz, faces(1), square + "4 0 1 2 3\n");
    const std::string strips = "property list int int vertex_indices\n";
    const std::vector<std::pair<std::string, std::string>> squares{
        {"plain", plain},
        {"CR LF", replaced(plain, "\n", "\r\n")},
        {"CR", replaced(plain, "\n", "\r")},
        {"empty lines", replaced(plain, "\n4 0", "\n\n \n4 0") + "\n\n"},
        {"blanks and tabs", replaced(replaced(plain, " ", " \t "), "\n", " \n")},
        {"byte order mark", "\xef\xbb\xbf" + plain},
        {"zero bytes at the end", plain + std::string(3, '\0')},
        {"no line end at the end", plain.substr(0, plain.size() - 1)},
        {"comments", replaced(plain, "element", "comment element face 9\nobj_info a\nelement")},
        {"other name", replaced(plain, "vertex_indices", "vertex_index")},
        {"doubles", replaced(plain, "float", "float64")},
        {"two triangles", ascii(4, xyz, faces(2), square + "3 0 1 2\n3 0 2 3\n")},
        {"two elements of faces",
         ascii(4, xyz, faces(1) + faces(1), square + "3 0 1 2\n3 0 2 3\n")},
        {"faces before vertices", "ply\nformat ascii 1.0\n" + faces(1) + "element vertex 4\n" +
                                      xyz + "end_header\n4 0 1 2 3\n" + square},
        {"a strip", ascii(4, xyz, "element tristrips 1\n" + strips, square + "4 0 1 3 2\n")},
        {"parted strips",
         ascii(4, xyz, "element tristrips 1\n" + strips, square + "9 -1 0 1 2 -1 0 2 3 -1\n")},
        {"two rows of strips",
         ascii(4, xyz, "element tristrips 2\n" + strips, square + "3 0 1 2\n3 0 2 3\n")},
    };
    for (const auto& [name, text] : squares) {
        EXPECT_EQ(file_facts("a.ply", text), "2 triangles") << name;
        EXPECT_NEAR(file_area("a.ply", text), 1, 1e-9) << name;
    }
}

// Along a strip every second triangle turns the other way round, so that all face one side.
TEST(PlyFile, StripsFaceOneSide) {
    const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
    const std::string points = "0 0 0\n0 0 1\n1 0 0\n1 0 1\n3 0 0\n3 0 1\n4 0 0\n";
    const std::string text = ascii(7, xyz, strips, points + "8 0 1 2 3 -1 4 5 6\n");
    EXPECT_EQ(file_facts("a.ply", text), "3 triangles");
    const Mesh mesh = read_mesh_bytes("a.ply", text);
    EXPECT_NEAR(area(mesh), 1.5, 1e-9);
    for (const Mesh::Triangle& t : mesh.triangles) { // all seen from above
        const Vec3 a = mesh.positions[t[0]];
        EXPECT_GT((mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).y, 0);
    }
    // Repeated corners lead to another place without a triangle.
    EXPECT_EQ(file_facts("a.ply", ascii(7, xyz, strips, points + "9 0 1 2 2 4 4 5 6 6\n")),
              "2 triangles");
}

TEST(PlyFile, WhatIsNotReadIsNamed) {
    const std::string colours = "property uchar red\nproperty uchar green\n";
    const std::vector<std::pair<std::string, std::string>> rows{
        {ascii(4, xyz + colours, faces(1), replaced(square, "\n", " 9 9\n") + "4 0 1 2 3\n"),
         "not read: red of vertex, green of vertex"},
        {ascii(4, xyz, faces(1, corners + "property list uchar float texcoord\n"),
               square + "4 0 1 2 3 2 0.5 1.5\n"),
         "not read: texcoord of face"},
        {ascii(4, xyz + "property float nx\n", faces(1),
               replaced(square, "\n", " 1\n") + "4 0 1 2 3\n"),
         "not read: nx of vertex"},
        {ascii(4, xyz, "element edge 2\nproperty int vertex1\nproperty int vertex2\n" + faces(1),
               square + "0 1\n1 2\n4 0 1 2 3\n"),
         "not read: 2 rows of element \"edge\""},
        {ascii(4, xyz, "element tags 1\nproperty list uchar uchar t\n" + faces(1),
               square + "3 7 7 7\n4 0 1 2 3\n"),
         "not read: 1 row of element \"tags\""},
    };
    for (const auto& [text, warning] : rows) {
        EXPECT_EQ(file_facts("a.ply", text), "2 triangles; " + warning);
        EXPECT_NEAR(file_area("a.ply", text), 1, 1e-9) << warning;
    }
    EXPECT_EQ(
        file_problem("a.ply", ascii(4, xyz, "element edge 1\nproperty int a\n", square + "0\n")),
        "a.ply: it has no triangles; not read: 1 row of element \"edge\"");
    EXPECT_EQ(file_facts("a.ply", ascii(4, xyz, faces(1), square + "4 0 2 1 3\n")),
              "1 triangles; 1 of its faces cross themselves, the first in line 14");
}

TEST(PlyFile, NormalsAndTextureCoordinates) {
    for (const auto& [u, w] : std::vector<std::pair<std::string, std::string>>{
             {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
        const FileMesh mesh = read_file_mesh_bytes(
            "a.ply", ascii(3, xyz + "property float " + u + "\nproperty float " + w + "\n",
                           faces(1), "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0.25 0.75\n3 0 1 2\n"));
        ASSERT_EQ(mesh.uvs.size(), 3U) << u;
        EXPECT_EQ(mesh.uvs[2], Vec2f(0.25F, 0.75F)) << u;
        EXPECT_TRUE(mesh.warnings.empty()) << u;
    }
}

TEST(PlyFile, Refused) {
    const auto rows_of = [](const std::string& rows) { return ascii(4, xyz, faces(1), rows); };
    const std::vector<std::pair<std::string, std::string>> rows{
        {rows_of(square + "4 0 1 2 3\n4 0 1 2 3\n"),
         "line 15: it goes on after the rows that its header counts"},
        {rows_of(square), "line 13: the file ends too early: its header counts 1 row of face"},
        {rows_of("0 0 0\n1 0 0\n"),
         "line 11: the file ends too early: its header counts 4 rows of vertex"},
        {rows_of("0 0 0 7\n"),
         "line 10: \"7\" follows the 3 numbers that the properties of vertex take"},
        {rows_of("0 0\n0\n"), "line 10: the row ends too early, after 2 numbers"},
        {rows_of("0 0 1,5\n"), "line 10: \"1,5\" is not a number; expected a decimal point, and no "
                               "commas between thousands"},
        {rows_of(square + "4 0 1 2 4\n"), "line 14: a face names vertex 4 of 4"},
        {rows_of(square + "4 0 1 2 -1\n"), "line 14: a face names vertex -1 of 4"},
        {rows_of(square + "3 0 1 1.5\n"), "line 14: a face names vertex 1.5 of 4"},
        {rows_of(square + "2 0 1\n"), "line 14: a face has 2 corners; expected at least 3"},
        {rows_of(square + "2.5 0 1\n"), "line 14: a list has an impossible length"},
        {rows_of(square + "-1\n"), "line 14: a list has an impossible length"},
        {ascii(4, xyz, "element face 1\nproperty int material\n", square + "1\n"),
         "its element \"face\" has no list vertex_indices or vertex_index"},
        {ascii(4, xyz, "element range_grid 1\n" + corners, square + "1 0\n"),
         "its element \"range_grid\" has a list of vertices that is not read; expected face or "
         "tristrips"},
        {ascii(1, xyz, "element vertex 1\n" + xyz + faces(1), "0 0 0\n0 0 0\n3 0 0 0\n"),
         "its header has several elements \"vertex\"; expected one"},
        {ascii(1, "property float x\nproperty float y\n", faces(1), "0 0\n"),
         "its vertices have no x, y, z"},
        {ascii(1, "property real x\n", "", ""), "line 4: unknown type \"real\""},
        {ascii(1, "propperty float x\n", "", ""),
         "line 4: \"propperty\" is not expected here; expected format, comment, element, property "
         "or end_header"},
        {"ply\nformat binary 1.0\n", "line 2: unknown format \"binary\"; expected ascii, "
                                     "binary_little_endian or binary_big_endian"},
        {"ply\nelement vertex -4\n", "line 2: an element has no valid number of rows"},
        {"ply\nproperty float x\n", "line 2: a property comes before the first element"},
        {"ply\nelement vertex 1\nproperty float\n", "line 3: a property has no name"},
        {"ply\nend_header\n", "its header names no format"},
        {"plywood\n", "it is not a PLY file"},
    };
    for (const auto& [text, problem] : rows)
        EXPECT_EQ(file_problem("a.ply", text), "a.ply: " + problem);
}

// The line end of the header may be followed by a byte of the body that looks like one.
TEST(PlyFile, BinaryBodiesAfterAnyLineEnd) {
    for (const std::string end : {"\n", "\r\n", "\r"})
        for (const bool big : {false, true}) {
            std::string text =
                std::string("ply\nformat binary_") + (big ? "big" : "little") +
                "_endian 1.0\nelement face 1\nproperty list uchar uchar vertex_index\n"
                "element vertex 10\nproperty double x\nproperty short y\nproperty double z\n"
                "end_header\n";
            text = replaced(text, "\n", end);
            text += char(10); // corners of the face: the code of LF
            for (int i = 0; i < 10; ++i)
                text += char(i);
            for (int i = 0; i < 10; ++i) {
                put(text, 5e6 - std::sin(2 * pi * i / 10), big);
                put(text, std::int16_t{-300}, big);
                put(text, 4e6 + std::cos(2 * pi * i / 10), big);
            }
            EXPECT_EQ(file_facts("a.ply", text), "8 triangles") << big;
            const FileMesh mesh = read_file_mesh_bytes("a.ply", text);
            EXPECT_NEAR(mesh.positions[1].x, 5e6 - std::sin(pi / 5), 1e-8);
            EXPECT_EQ(mesh.positions[1].y, -300);
            EXPECT_EQ(file_problem("a.ply", text + "more"),
                      "a.ply: 4 bytes follow the rows that its header counts");
            EXPECT_EQ(file_facts("a.ply", text + end), "8 triangles"); // many writers do
            EXPECT_EQ(file_problem("a.ply", text.substr(0, text.size() - 1)),
                      "a.ply: vertex 9: the file ends too early");
            text[text.size() - 180 - 1] = char(12);
            EXPECT_EQ(file_problem("a.ply", text), "a.ply: face 0: a face names vertex 12 of 10");
        }
}

} // namespace
} // namespace scree
