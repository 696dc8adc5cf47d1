// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/read_mesh.h"

#include "core/error.h"
#include "core/file.h"

#include <algorithm>
#include <filesystem>

namespace scree {

namespace {

FileMesh read_by_ending(const std::string& path, std::string_view bytes) {
    const std::string ending = extension(path);
    const std::string folder = std::filesystem::path(path).parent_path().string();
    if (ending == "obj")
        return read_obj(bytes, folder);
    if (ending == "ply")
        return read_ply(bytes);
    if (ending == "stl")
        return read_stl(bytes);
    if (ending == "3ds")
        return read_3ds(bytes);
    if (ending == "gltf" || ending == "glb")
        return read_gltf(bytes, folder);
    throw Error("is not a mesh that can be read; expected .obj, .ply, .stl, .gltf, .glb or .3ds");
}

// Products of three coordinates must stay finite in single precision.
constexpr double largest_position = 1e12;

template <class T>
void drop(std::vector<T>& values, FileMesh& mesh, const char* why) {
    values.clear();
    mesh.warnings.emplace_back(std::string("its ") + why);
}

// Checks a reader's mesh: indices in range, positions finite, normals and UVs valid or dropped.
void check(FileMesh& mesh) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            if (!std::isfinite(mesh.positions[i][axis]))
                throw Error("vertex " + std::to_string(i) + " has a position that is not a number");
            if (std::abs(mesh.positions[i][axis]) > largest_position)
                throw Error("vertex " + std::to_string(i) + " lies more than 1e12 away");
        }
    for (const Mesh::Triangle& t : mesh.triangles)
        for (const std::uint32_t index : t)
            if (index >= mesh.positions.size())
                throw Error("a face names vertex " + std::to_string(index) + " of " +
                            std::to_string(mesh.positions.size()));
    if (mesh.triangles.empty())
        throw Error("it has no triangles");
    const auto has_area = [&](const Mesh::Triangle& t) {
        const auto& a = mesh.positions[t[0]];
        return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).length2() > 0;
    };
    if (std::none_of(mesh.triangles.begin(), mesh.triangles.end(), has_area))
        throw Error("none of its triangles has an area");
    const auto bad_normal = [](const Vec3& n) { return !is_finite(n) || n.length() < 1e-6F; };
    if (std::any_of(mesh.normals.begin(), mesh.normals.end(), bad_normal))
        drop(mesh.normals, mesh, "normals are not read, since one is 0 or not a number");
    if (mesh.normals.size() != mesh.positions.size())
        mesh.normals.clear();
    for (Vec3& n : mesh.normals)
        n.normalize();
    const auto bad_uv = [](const Vec2f& t) { return !std::isfinite(t.x) || !std::isfinite(t.y); };
    if (std::any_of(mesh.uvs.begin(), mesh.uvs.end(), bad_uv))
        drop(mesh.uvs, mesh, "texture coordinates are not read, since one is not a number");
    if (mesh.uvs.size() != mesh.positions.size())
        mesh.uvs.clear();
}

} // namespace

FileMesh read_file_mesh_bytes(const std::string& path, std::string_view bytes) {
    try {
        FileMesh mesh = read_by_ending(path, bytes);
        check(mesh);
        return mesh;
    } catch (const Error& problem) {
        throw Error(path + ": " + problem.diagnostics().front().message);
    } catch (const std::bad_alloc&) {
        throw Error::resource(path + ": there is not enough memory to read it");
    } catch (const std::exception& problem) { // thrown by a library
        throw Error(path + ": it is damaged: " + problem.what());
    }
}

FileMesh read_file_mesh(const std::string& path) {
    return read_file_mesh_bytes(path, read_file(path)); // errors of read_file already name the file
}

Mesh read_mesh(const std::string& path) { return read_mesh_bytes(path, read_file(path)); }

Mesh read_mesh_bytes(const std::string& path, std::string_view bytes) {
    Mesh mesh = to_mesh(read_file_mesh_bytes(path, bytes));
    mesh.name = file_name(path);
    return mesh;
}

} // namespace scree
