// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/read_mesh.h"
#include "formats/table.h"

#include "core/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace scree {

namespace {

// "did you mean bunny.obj?" for a missing file with a similarly named neighbour.
std::string near_file(const std::string& path) {
    std::vector<std::string> names;
    std::error_code code;
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    for (const auto& entry :
         std::filesystem::directory_iterator(folder.empty() ? "." : folder, code))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end()); // folders are listed in unspecified order
    return did_you_mean(file_name(path), names);
}

Mesh read_located(const Params& params) {
    const std::string& path = params.text("path");
    try {
        return read_mesh(path);
    } catch (const Error& problem) {
        const bool missing = !std::filesystem::exists(path);
        throw params.error("path", problem.diagnostics().front().message,
                           missing ? near_file(path) : std::string());
    }
}

Mesh make(const Params& params) {
    Mesh mesh = read_located(params);
    if (params.text("up") == "z") {
        Matrix y_from_z(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
        transform(mesh, y_from_z);
    }
    if (params.flag("closed")) {
        const MeshFacts facts = inspect(mesh);
        if (!facts.closed())
            throw params.error(
                "path", fmt::format("{}: the mesh is open: {} boundary edges, {} non-manifold "
                                    "edges; expected a closed mesh",
                                    mesh.name, facts.boundary_edges, facts.non_manifold_edges));
    }
    if (mesh.normals.empty())
        compute_normals(mesh, params.number("crease"));
    if (params.has("size"))
        normalise_size(mesh, params.number("size"));
    return mesh;
}

} // namespace

Registry<Mesh(const Params& params)> mesh_file_table() {
    Registry<Mesh(const Params& params)> table("mesh");
    table.add({
        "file",
        "A mesh read from an OBJ, PLY, STL, glTF or 3DS file.",
        {
            {.name = "path",
             .type = ParamType::path,
             .doc = "The file: .obj, .ply, .stl, .gltf, .glb or .3ds."},
            {.name = "size",
             .type = ParamType::number,
             .doc = "Longest side of the mesh's bounding box after scaling; the mesh is also moved "
                    "to stand on y = 0, centred on the y axis. Unchanged when not given.",
             .unit = "m",
             .optional = true,
             .min = 1e-6,
             .max = 1e6},
            {.name = "up",
             .type = ParamType::choice,
             .doc = "Which axis of the file points up.",
             .fallback = std::string("y"),
             .choices = {"y", "z"}},
            {.name = "crease",
             .type = ParamType::number,
             .doc = "Edges that bend more than this stay sharp; for files without normals.",
             .unit = "deg",
             .fallback = 40.0,
             .min = 0.0,
             .max = 180.0},
            {.name = "closed",
             .type = ParamType::boolean,
             .doc = "Whether an open mesh is an error.",
             .fallback = false},
        },
        make,
    });
    return table;
}

} // namespace scree
