// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes far from the origin are moved there before their positions become single, or refused.
#include "formats/placed_mesh.h"
#include "formats/table.h"

#include "core/file.h"
#include "tests/support/folder.h"
#include "tests/support/mesh_text.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using Imath::V3d;

// A regular polygon of radius 0.3 around a place, as survey software writes it.
std::string polygon(const V3d& centre, int corners, bool ply) {
    std::string points;
    std::string face;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * i / corners;
        points += fmt::format("{}{:.9f} {:.9f} {:.9f}\n", ply ? "" : "v ",
                              centre.x + 0.3 * std::cos(angle), centre.y,
                              centre.z + 0.3 * std::sin(angle));
        face += fmt::format(" {}", ply ? i : i + 1);
    }
    if (!ply)
        return points + "f" + face + "\n";
    return fmt::format("ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty "
                       "double y\nproperty double z\nelement face 1\nproperty list uchar int "
                       "vertex_index\nend_header\n{}{}{}\n",
                       corners, points, corners, face);
}

class PlacedMesh : public testing::Test {
  protected:
    Mesh make(const std::string& name, const std::string& bytes,
              const std::vector<std::pair<std::string, Value>>& values) {
        const std::string path = folder_.file(name);
        write_file(path, bytes);
        const auto table = mesh_file_table();
        Params params("mesh.file", {"site.lua", 3});
        params.set_warnings(warnings_);
        for (const ParamSpec& spec : table.plugins().front().params)
            params.set(spec.name, default_value(spec));
        params.set("path", path, {"site.lua", 4});
        for (const auto& [key, value] : values)
            params.set(key, value);
        return table.plugins().front().make(params);
    }

    std::string problem(const std::string& name, const std::string& bytes,
                        const std::vector<std::pair<std::string, Value>>& values) {
        try {
            make(name, bytes, values);
        } catch (const Error& error) {
            std::string text = error.what();
            text.erase(text.find(folder_.path().string()), folder_.path().string().size() + 1);
            return text;
        }
        return "no error";
    }

    test::Folder folder_;
    std::shared_ptr<Warnings> warnings_ = std::make_shared<Warnings>();
};

TEST_F(PlacedMesh, SurveysKeepTheirShape) {
    constexpr int corners = 48;
    const double unit_area = 0.5 * corners * std::sin(2 * pi / corners); // of radius 1
    for (const V3d& at : {V3d(7502223.336235, 12, 4485513.721904), V3d(-5e6, 4e6, 800),
                          V3d(1e9, 0, 1e9), V3d(0, 0, 0)})
        for (const bool ply : {false, true}) {
            const std::string name = ply ? "a.ply" : "a.obj";
            const std::string bytes = polygon(at, corners, ply);
            const Mesh moved = make(name, bytes, {{"centre", true}});
            const double digits = at.x > 1e8 ? 1e-3 : 1e-5; // the file's own at 1e9
            EXPECT_NEAR(area(moved), 0.09 * unit_area, digits) << at;
            const Box3 box = bounds(moved);
            EXPECT_NEAR(box.size().x, 0.6, 1e-5) << at;
            EXPECT_NEAR(box.center().x, 0, 1e-6) << at;
            EXPECT_NEAR(box.center().z, 0, 1e-6) << at;
            EXPECT_EQ(box.min.y, 0) << at;
            EXPECT_NEAR(area(make(name, bytes, {{"size", 2.0}})), unit_area, 10 * digits) << at;
        }
}

TEST_F(PlacedMesh, UpIsTurnedBeforeItIsCentred) {
    const Mesh mesh =
        make("a.obj", "v 5e6 4e6 100\nv 5000001 4e6 100\nv 5e6 4000002 103\nf 1 2 3\n",
             {{"centre", true}, {"up", std::string("z")}});
    EXPECT_EQ(bounds(mesh).min, Vec3(-0.5F, 0, -1));
    EXPECT_EQ(bounds(mesh).max, Vec3(0.5F, 3, 1));
}

TEST_F(PlacedMesh, DistortedMeshesAreRefused) {
    EXPECT_EQ(problem("a.obj", polygon(V3d(7502223.336235, 12, 4485513.721904), 48, false), {}),
              "site.lua:4: mesh.file.path: a.obj: the mesh is 0.6 long and lies up to 8740892 from "
              "the origin: single precision would move its vertices by up to 0.24\n"
              "  centre = true moves it to the origin, size = also scales it");
    // A box of 10 km with faces of 0.1 mm at its corners.
    EXPECT_EQ(problem("a.obj",
                      "v 0 0 0\nv 0.0001 0 0\nv 0 0 0.0001\nf 1 2 3\nv 10000.00003 0 1\nv "
                      "10000.0001 0 1\nv 10000.00003 0 1.0001\nf 4 5 6\n",
                      {}),
              "site.lua:4: mesh.file.path: a.obj: the mesh is 1e+04 long and lies up to 10000 from "
              "the origin: single precision would move its vertices by up to 0.0001\n"
              "  centre = true moves it to the origin, size = also scales it");
}

TEST_F(PlacedMesh, ExactAndNearMeshesAreTaken) {
    EXPECT_EQ(problem("a.obj", polygon(V3d(20, 0, 20), 48, false), {}), "no error");
    // Whole metres up to 2^24 are exact.
    const Mesh mesh = make("a.obj", "v 5000000 0 0\nv 5000001 0 0\nv 5000000 0 1\nf 1 2 3\n", {});
    EXPECT_NEAR(area(mesh), 0.5, 1e-9);
    EXPECT_EQ(bounds(mesh).min.x, 5e6F);
}

TEST_F(PlacedMesh, WarningsAreLocated) {
    make("a.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\nl 1 2\n", {});
    ASSERT_EQ(warnings_->size(), 1U);
    EXPECT_EQ(warnings_->front().text(), "site.lua:4: mesh.file.path: " + folder_.file("a.obj") +
                                             ": not read: lines (line 5)");
}

} // namespace
} // namespace scree
