// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/located.h"
#include "core/random.h"
#include "model/file_material.h"
#include "model/table.h"

namespace scree {

namespace {

std::vector<ParamSpec> object_params() {
    return {
        {.name = "shape", .type = ParamType::object, .families = {"mesh"}, .doc = "Its mesh."},
        shape_material_spec("Its material"),
        {.name = "position",
         .type = ParamType::vector3,
         .doc = "Position of the mesh's origin.",
         .unit = "m",
         .fallback = Vec3(0.0F)},
        {.name = "rotation",
         .type = ParamType::vector3,
         .doc = "Rotation about the x axis, then y, then z, each through the mesh's origin.",
         .unit = "deg",
         .fallback = Vec3(0.0F)},
        {.name = "scale",
         .type = ParamType::vector3,
         .doc = "Factors along x, y and z, applied before the rotation; one number for all three.",
         .fallback = Vec3(1.0F),
         .min = 0.0,
         .max = 1e6,
         .above_min = true,
         .uniform = true},
    };
}

// Matrices multiply row vectors, so the leftmost is applied first.
Matrix object_matrix(const Params& params) {
    const Vec3& rotation = params.vector3("rotation");
    Matrix scale;
    Matrix about_x;
    Matrix about_y;
    Matrix about_z;
    Matrix move;
    scale.setScale(params.vector3("scale"));
    about_x.setAxisAngle(Vec3(1, 0, 0), rotation.x);
    about_y.setAxisAngle(Vec3(0, 1, 0), rotation.y);
    about_z.setAxisAngle(Vec3(0, 0, 1), rotation.z);
    move.setTranslation(params.vector3("position"));
    return scale * about_x * about_y * about_z * move;
}

SceneItem object_item(const Params& params) {
    Aggregate object;
    object.generator = "object";
    const auto mesh = params.object<Mesh>("shape");
    object.prototypes.push_back({mesh->name, mesh, nullptr, materials_of(params, mesh.get())});
    Instance instance;
    instance.world_from_object = object_matrix(params);
    object.instances.push_back(instance);
    return {"object",
            [object = std::move(object)](const Context&, std::uint64_t number) {
                Aggregate out = object;
                out.instances.front().random =
                    Random(0, Purpose::instance_attribute, number).uniform_float();
                return out;
            },
            params.where()};
}

} // namespace

Registry<MakeItem> object_table() {
    Registry<MakeItem> table("object");
    table.add({"object", "A single mesh.", object_params(), object_item});
    return table;
}

Registry<MakeItem> generator_items(const Registry<Bake>& table) {
    Registry<MakeItem> items(table.family());
    for (const Plugin<Bake>& plugin : table.plugins())
        items.add({plugin.name, plugin.doc, plugin.params,
                   [name = plugin.name, bake = plugin.make](const Params& params) -> SceneItem {
                       return {name,
                               [bake, params](const Context& context, std::uint64_t) {
                                   return located(params, [&] { return bake(params, context); });
                               },
                               params.where()};
                   }});
    return items;
}

} // namespace scree
