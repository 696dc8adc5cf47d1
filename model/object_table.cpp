// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/located.h"
#include "core/random.h"
#include "geometry/mesh/not_closed.h"
#include "model/file_material.h"
#include "model/table.h"

#include <algorithm>

namespace scree {

namespace {

ParamSpec name_spec() {
    return {.name = "name",
            .type = ParamType::text,
            .doc = "What messages, statistics and reports call it; --object takes it too.",
            .fallback = std::string()};
}

std::vector<ParamSpec> object_params() {
    return {
        {.name = "shape",
         .type = ParamType::object,
         .families = {"mesh", "curve"},
         .doc = "Its mesh, or its strands."},
        shape_material_spec("Its material"),
        {.name = "position",
         .type = ParamType::point3,
         .doc = "Where the shape's origin is put: of most meshes their foot, so that y = 0 stands "
                "them on the ground and y = 1 lifts their lowest point to 1 m.",
         .unit = "m",
         .fallback = WideVec3(0)},
        {.name = "rotation",
         .type = ParamType::vector3,
         .doc = "Rotation about the x axis, then y, then z, each through the shape's origin.",
         .unit = "deg",
         .fallback = Vec3(0.0F)},
        {.name = "scale",
         .type = ParamType::vector3,
         .doc = "Factors along x, y and z, applied before the rotation; one number for all three.",
         .fallback = Vec3(1.0F),
         .min = 1e-6,
         .max = 1e6,
         .uniform = true},
        name_spec(),
    };
}

// Matrices multiply row vectors, so the leftmost is applied first.
WideMatrix object_matrix(const Params& params) {
    const Vec3& rotation = params.vector3("rotation");
    Matrix scale;
    Matrix about_x;
    Matrix about_y;
    Matrix about_z;
    scale.setScale(params.vector3("scale"));
    about_x.setAxisAngle(Vec3(1, 0, 0), rotation.x);
    about_y.setAxisAngle(Vec3(0, 1, 0), rotation.y);
    about_z.setAxisAngle(Vec3(0, 0, 1), rotation.z);
    WideMatrix move;
    move.setTranslation(params.point3("position"));
    return WideMatrix(scale * about_x * about_y * about_z) * move;
}

/// Says what a material that lets light through would show wrongly on the mesh.
void warn_of_inside(const Params& params, const Mesh& mesh) {
    const char* const why = "; what is inside of it, and thus how light is bent, is not known";
    if (const MeshFacts facts = inspect(mesh); !facts.closed())
        params.warn("material", mesh.name + ": " + not_closed(facts) + why,
                    "expected a closed mesh for glass and translucent");
    else if (volume(mesh) < 0)
        params.warn("material", mesh.name + ": its faces point inwards" + why,
                    "turn them in the program that made it");
}

void warn_of_inside(const Params& params, const Prototype& prototype) {
    if (std::ranges::none_of(prototype.materials,
                             [](const auto& m) { return m && has_inside(*m); }))
        return;
    if (const Mesh* mesh = prototype.mesh())
        warn_of_inside(params, *mesh);
    else if (prototype.strands()->kind != CurveKind::linear)
        params.warn("material",
                    prototype.name + ": the ends of splines are open; what is inside is not known",
                    "expected curve.polyline for glass and translucent");
}

Prototype prototype_of(const Params& params) {
    if (const auto strands = params.object<Strands>("shape"))
        return {
            .name = strands->name, .shape = strands, .materials = materials_of(params, nullptr)};
    const auto mesh = params.object<Mesh>("shape");
    return {.name = mesh->name, .shape = mesh, .materials = materials_of(params, mesh.get())};
}

SceneItem object_item(const Params& params) {
    Aggregate object;
    object.generator = "object";
    object.name = params.text("name");
    object.prototypes.push_back(prototype_of(params));
    warn_of_inside(params, object.prototypes.front());
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
            params.where(), params.text("name")};
}

} // namespace

Registry<MakeItem> object_table() {
    Registry<MakeItem> table("object");
    table.add({"object", "A single shape.", object_params(), object_item});
    return table;
}

Registry<MakeItem> generator_items(const Registry<Generator>& table) {
    Registry<MakeItem> items(table.family());
    for (const Plugin<Generator>& plugin : table.plugins()) {
        std::vector<ParamSpec> specs = plugin.params;
        specs.push_back(name_spec());
        items.add(
            {plugin.name, plugin.doc, std::move(specs),
             [kind = plugin.name, make = plugin.make](const Params& params) -> SceneItem {
                 const std::string& name = params.text("name");
                 const ParamPlace place{params.where(), params.path()};
                 return {kind,
                         [bake = make(params), place, name](const Context& context, std::uint64_t) {
                             Aggregate made = located(place, [&] { return bake(context); });
                             made.name = name;
                             return made;
                         },
                         params.where(), name};
             }});
    }
    return items;
}

} // namespace scree
