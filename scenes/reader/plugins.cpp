// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/plugins.h"

namespace scree {

Tables::Tables() {
    for (const Registry<MakeMesh>& part : {component_table(), mesh_file_table()})
        for (const Plugin<MakeMesh>& plugin : part.plugins())
            mesh.add(plugin);
}

const Tables& tables() {
    static const Tables all;
    return all;
}

const std::vector<ParamSpec>& object_params() {
    static const std::vector<ParamSpec> params{
        {.name = "shape", .type = ParamType::mesh, .doc = "What it looks like."},
        {.name = "material",
         .type = ParamType::material,
         .doc = "What it is made of; grey matte when not given.",
         .fallback = MaterialId{0}},
        {.name = "position",
         .type = ParamType::vector3,
         .doc = "Where the mesh's origin goes.",
         .unit = "m",
         .fallback = Vec3(0.0F)},
        {.name = "rotation",
         .type = ParamType::vector3,
         .doc = "Turn about the x axis, then y, then z, each through the mesh's origin.",
         .unit = "deg",
         .fallback = Vec3(0.0F)},
        {.name = "scale",
         .type = ParamType::vector3,
         .doc = "Factor along x, y and z before the turn; one number for all three.",
         .fallback = Vec3(1.0F),
         .min = 0.0,
         .max = 1e6,
         .above_min = true},
    };
    return params;
}

namespace {

template <class Make>
void add_rows(const Registry<Make>& table, std::vector<PluginRow>& rows) {
    for (const Plugin<Make>& plugin : table.plugins())
        rows.push_back({table.family(), plugin.name, plugin.doc, plugin.params});
}

} // namespace

std::vector<PluginRow> all_plugins() {
    const Tables& all = tables();
    const Plugin<MakeFilm>& film = all.film.plugins().front();
    std::vector<PluginRow> rows{{{},
                                 "scene",
                                 "What a script returns.",
                                 {{.name = "film",
                                   .type = ParamType::record,
                                   .doc = "The picture: see film.",
                                   .optional = true},
                                  {.name = "camera",
                                   .type = ParamType::record,
                                   .doc = "A camera.*; baking does without.",
                                   .optional = true},
                                  {.name = "lights",
                                   .type = ParamType::list,
                                   .doc = "A list of light.*.",
                                   .optional = true},
                                  {.name = "objects",
                                   .type = ParamType::list,
                                   .doc = "A list of generator.* and object.",
                                   .min_items = 1}}},
                                {{}, "object", "One mesh in its place.", object_params()},
                                {{}, "film", film.doc, film.params}};
    add_rows(all.camera, rows);
    add_rows(all.light, rows);
    add_rows(all.material, rows);
    add_rows(all.mesh, rows);
    add_rows(all.region, rows);
    add_rows(all.field, rows);
    add_rows(all.generator, rows);
    add_rows(all.procedural, rows);
    return rows;
}

} // namespace scree
