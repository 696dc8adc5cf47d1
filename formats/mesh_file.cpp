// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/placed_mesh.h"
#include "formats/read_mesh.h"
#include "formats/table.h"

#include "core/file.h"

#include <fmt/format.h>

#include <array>

namespace scree {

namespace {

/// A unit of length that files are in.
struct FileUnit {
    std::string name;
    double metres = 1;
};
const std::array<FileUnit, 5> file_units{
    {{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}};

std::vector<std::string> unit_names() {
    std::vector<std::string> names;
    for (const FileUnit& unit : file_units)
        names.push_back(unit.name);
    return names;
}

// Without a unit, a longer mesh is more likely to be in millimetres than in metres.
constexpr double suspicious_length = 10; // [m]

FileMesh read_located(const Params& params) {
    const std::string& path = params.text("path");
    try {
        FileMesh mesh = read_file_mesh(path);
        for (const std::string& warning : mesh.warnings)
            params.warn("path", path + ": " + warning);
        return mesh;
    } catch (const Error& problem) {
        throw params.error("path", problem.diagnostics().front().message,
                           problem.diagnostics().front().hint);
    }
}

// Converts to metres. A glTF is in metres by its standard (Khronos, glTF 2.0, section 3.4).
void apply_unit(FileMesh& mesh, const Params& params) {
    const std::string& path = params.text("path");
    const std::string ending = extension(path);
    const bool is_gltf = ending == "gltf" || ending == "glb";
    if (params.has("unit")) {
        if (is_gltf)
            throw params.error("unit", "a glTF file is in metres by its standard",
                               "leave it away; size and object.scale change a mesh too");
        for (const FileUnit& unit : file_units)
            if (unit.name == params.text("unit"))
                scale(mesh, unit.metres);
    } else if (const double length = longest_side(mesh);
               !is_gltf && !params.has("size") && length > suspicious_length) {
        params.warn("path",
                    fmt::format("{}: is {:.4g} m long, its numbers taken as metres", path, length),
                    "if the file is in millimetres, say unit = \"mm\"; unit = \"m\" if in metres");
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
    apply_unit(placed, params);
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
            {.name = "unit",
             .type = ParamType::choice,
             .doc = "The unit of the file's numbers; metres when not given. A glTF is always in "
                    "metres.",
             .optional = true,
             .choices = unit_names()},
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
