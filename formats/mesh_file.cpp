// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/file_placement.h"
#include "formats/placed_mesh.h"
#include "formats/read_mesh.h"
#include "formats/table.h"

#include "core/file.h"
#include "core/text.h"

#include <fmt/format.h>

namespace scree {

namespace {

FileMesh read_located(const Params& params) {
    const std::string& path = params.text("path");
    try {
        FileMesh mesh = read_file_mesh(path);
        for (const std::string& warning : mesh.warnings)
            params.warn("path", fmt::format("{}: {}", path, warning));
        return mesh;
    } catch (const Error& problem) {
        throw params.error("path", problem.diagnostics().front().message,
                           problem.diagnostics().front().hint);
    }
}

// A glTF is in metres by its standard (Khronos, glTF 2.0, section 3.4).
std::string why_metres(const std::string& path) {
    const std::string ending = extension(path);
    return ending == "gltf" || ending == "glb" ? "a glTF file is in metres by its standard" : "";
}

// Places the mesh as the parameters say. One that stays where it is must not lie so far from the
// origin that single precision distorts it.
FilePlacement place(FileMesh& mesh, const Params& params) {
    Imath::Box3d box;
    for (const Imath::V3d& p : mesh.positions)
        box.extendBy(p);
    FilePlacement placement(params, box, why_metres(params.text("path")));
    for (Imath::V3d& p : mesh.positions)
        p = placement(p);
    for (Vec3& n : mesh.normals)
        n = placement.turned(n);
    if (placement.centred())
        return placement;
    if (const Rounding r = rounding(mesh); r.shows())
        throw params.error(
            "path",
            fmt::format("{}: the mesh is {:.3g} long and lies up to {:.7g} from the origin: single "
                        "precision would move its vertices by up to {:.2g}",
                        params.text("path"), r.longest, r.distance, r.moved),
            "centre = true moves it to the origin, size = also scales it");
    return placement;
}

Mesh make(const Params& params) {
    FileMesh placed = read_located(params);
    const FilePlacement placement = place(placed, params);
    Mesh mesh = to_mesh(placed);
    mesh.unit_unknown = placement.unit_unknown();
    mesh.name = file_name(params.text("path"));
    if (params.flag("closed")) {
        const MeshFacts facts = inspect(mesh);
        if (!facts.closed())
            throw params.error(
                "path", fmt::format("{}: the mesh is open: {}, {}; expected a closed mesh",
                                    mesh.name, counted(facts.boundary_edges, "boundary edge"),
                                    counted(facts.non_manifold_edges, "non-manifold edge")));
    }
    if (mesh.normals.empty())
        compute_normals(mesh, params.number("crease"));
    return mesh;
}

} // namespace

Registry<Mesh(const Params& params)> mesh_file_table() {
    std::vector<ParamSpec> specs{{.name = "path",
                                  .type = ParamType::path,
                                  .doc = "The file: .obj, .ply, .stl, .gltf, .glb or .3ds."}};
    for (ParamSpec& spec : placement_specs("A glTF is always in metres."))
        specs.push_back(std::move(spec));
    specs.push_back({.name = "crease",
                     .type = ParamType::number,
                     .doc = "Edges that bend more than this stay sharp; for files without normals.",
                     .unit = "deg",
                     .fallback = 40.0,
                     .min = 0.0,
                     .max = 180.0});
    specs.push_back({.name = "closed",
                     .type = ParamType::boolean,
                     .doc = "Whether an open mesh is an error.",
                     .fallback = false});
    Registry<Mesh(const Params& params)> table("mesh");
    table.add({"file",
               "A mesh read from an OBJ, PLY, STL, glTF or 3DS file. Its origin is the file's; "
               "with `size` or `centre` it is its foot, below its middle.",
               std::move(specs), make});
    return table;
}

} // namespace scree
