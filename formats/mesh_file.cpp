// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/placed_mesh.h"
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

FileMesh read_located(const Params& params) {
    const std::string& path = params.text("path");
    try {
        FileMesh mesh = read_file_mesh(path);
        for (const std::string& warning : mesh.warnings)
            params.warn("path", path + ": " + warning);
        return mesh;
    } catch (const Error& problem) {
        const bool missing = !std::filesystem::exists(path);
        throw params.error("path", problem.diagnostics().front().message,
                           missing ? near_file(path) : std::string());
    }
}

// Places the mesh as the parameters say. One that stays where it is must not lie so far from the
// origin that single precision distorts it.
void place(FileMesh& mesh, const Params& params) {
    if (params.text("up") == "z")
        turn_z_up(mesh);
    if (params.has("size"))
        centre(mesh, params.number("size"));
    else if (params.flag("centre"))
        centre(mesh, {});
    else if (const Rounding r = rounding(mesh); r.shows())
        throw params.error(
            "path",
            fmt::format("{}: the mesh is {:.3g} long and lies up to {:.7g} from the origin: single "
                        "precision would move its vertices by up to {:.2g}",
                        params.text("path"), r.longest, r.distance, r.moved),
            "centre = true moves it to the origin, size = also scales it");
}

Mesh make(const Params& params) {
    FileMesh placed = read_located(params);
    place(placed, params);
    Mesh mesh = to_mesh(placed);
    mesh.name = file_name(params.text("path"));
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
            {.name = "centre",
             .type = ParamType::boolean,
             .doc = "Whether the mesh is moved as with `size`, but not scaled. Files of millions "
                    "of metres, as those of surveys, need one of both.",
             .fallback = false},
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
