// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/texture_subject.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace scree {

namespace {

float roughness_of(const Material& material) {
    return std::visit(
        [](const auto& m) {
            if constexpr (requires { m.roughness; })
                return m.roughness;
            else
                return ShadingSample::unset;
        },
        material);
}

std::shared_ptr<const Procedural> procedural_of(const Prototype& prototype) {
    const Paint* paint = paint_of(prototype.materials);
    return paint == nullptr || !paint->palette.empty() ? nullptr : paint->texture.procedural;
}

bool has_shape(const Prototype& prototype) {
    return prototype.mesh() != nullptr || prototype.strands() != nullptr;
}

/// By what factors a matrix stretches the object's axes.
Vec3 stretch_of(const WideMatrix& m) {
    Vec3 stretch;
    for (int axis = 0; axis < 3; ++axis)
        stretch[axis] = static_cast<float>(WideVec3(m[axis][0], m[axis][1], m[axis][2]).length());
    return stretch;
}

std::vector<std::uint32_t> textured_prototypes(const Aggregate& aggregate) {
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < aggregate.prototypes.size(); ++i)
        if (has_shape(aggregate.prototypes[i]) && !aggregate.prototypes[i].picture &&
            procedural_of(aggregate.prototypes[i]))
            out.push_back(i);
    return out;
}

/// The index of the selected item.
std::size_t chosen_item(const std::string& scene_path, const Scene& scene, int number) {
    if (number > 0)
        return std::size_t(number) - 1;
    std::vector<std::size_t> found; // counted from 1
    for (std::size_t i = 0; i < scene.aggregates.size(); ++i)
        if (!textured_prototypes(scene.aggregates[i]).empty())
            found.push_back(i + 1);
    if (found.empty())
        throw Error(Diagnostic{{scene_path, 0},
                               "scene.objects",
                               "no object has a procedural; expected a material whose color is a "
                               "procedural.*",
                               "scree list shows what there is"});
    if (found.size() > 1)
        throw Error::usage(fmt::format("{}: the objects {} have a procedural; choose one",
                                       scene_path, fmt::join(found, ", ")),
                           fmt::format("for example --object {}, counted in the order of "
                                       "scene.objects, or its name",
                                       found.front()));
    return found.front() - 1;
}

} // namespace

Error TextureSubject::mesh_error(const std::string& message, const std::string& hint) const {
    return Error(Diagnostic{where, is_object ? kind + ".shape" : kind,
                            source.mesh->name + " " + message, hint});
}

Error TextureSubject::material_error(const std::string& message, const std::string& hint) const {
    return Error(Diagnostic{where, is_object ? kind + ".material" : kind, message, hint});
}

TextureSubject texture_subject(const std::string& scene_path, const Scene& scene, int number) {
    const std::size_t index = chosen_item(scene_path, scene, number);
    const Aggregate& aggregate = scene.aggregates[index];
    const bool is_object = aggregate.generator == "object";
    const std::string kind = (is_object ? "" : "generator.") + title(aggregate);
    const std::vector<std::uint32_t> found = textured_prototypes(aggregate);
    if (found.empty())
        throw Error(Diagnostic{aggregate.where, is_object ? kind + ".material" : kind,
                               fmt::format("object {} has no procedural; expected a material whose "
                                           "color is a procedural.*",
                                           index + 1),
                               ""});
    if (found.size() > 1)
        throw Error(Diagnostic{aggregate.where, kind,
                               fmt::format("{} of its components have a procedural; a texture is "
                                           "of one",
                                           found.size()),
                               "put the one you want into an object { shape, material }"});
    const Prototype& prototype = aggregate.prototypes[found.front()];
    if (prototype.strands() != nullptr)
        throw Error(Diagnostic{aggregate.where, is_object ? kind + ".shape" : kind,
                               prototype.name + " is of strands; a texture needs a mesh", ""});
    TextureSubject subject;
    subject.where = aggregate.where;
    subject.kind = kind;
    subject.is_object = is_object;
    subject.source.mesh = std::get<std::shared_ptr<const Mesh>>(prototype.shape);
    subject.source.procedural = procedural_of(prototype);
    subject.source.roughness = roughness_of(*prototype.materials.front());
    std::vector<const Instance*> places;
    for (const Instance& instance : aggregate.instances)
        if (instance.prototype == found.front())
            places.push_back(&instance);
    if (!places.empty()) {
        subject.source.random = places.front()->random;
        subject.source.stretch = stretch_of(places.front()->world_from_object);
        for (const Instance* place : places)
            if ((stretch_of(place->world_from_object) - subject.source.stretch).length() >
                1e-4F * subject.source.stretch.length())
                subject.scales_differ = true;
    }
    if (places.size() == 1)
        subject.world_from_object = places.front()->world_from_object;
    return subject;
}

} // namespace scree
