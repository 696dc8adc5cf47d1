// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/kind_drafts.h"

#include "core/parallel.h"

#include <fmt/format.h>

namespace scree {

namespace {

/// What the component looks like, in each of its shapes; `first` is the number of its first kind.
std::vector<Prototype> prototypes_of(const ComponentSettings& component, std::uint64_t seed,
                                     std::size_t first) {
    Prototype prototype;
    prototype.shape = component.shape;
    prototype.name = component.shape->name;
    prototype.materials = component.materials;
    if (!component.variation)
        return {prototype};
    const ShapeVariation& variation = *component.variation;
    std::vector<Prototype> shapes(variation.shapes, prototype);
    for (std::uint32_t i = 0; i < variation.shapes; ++i) {
        shapes[i].shape = std::make_shared<const Mesh>(located(component.bend_place, [&] {
            return varied_shape(*prototype.mesh(), variation, i,
                                Random(seed, Purpose::pile_shape, first + i));
        }));
        shapes[i].name = fmt::format("{}_{}", prototype.name, i + 1);
    }
    return shapes;
}

} // namespace

KindDrafts::KindDrafts(std::span<const ComponentSettings> components, std::uint64_t seed) {
    for (const ComponentSettings& component : components) {
        const std::size_t first = kinds.size();
        std::vector<Prototype> shapes = prototypes_of(component, seed, first);
        kinds.resize(first + shapes.size());
        completions.resize(kinds.size());
        parallel_for(shapes.size(), 1, [&](std::size_t i) {
            BodyDraft draft = located(component.shape_place, [&] {
                return draft_body(std::get<std::shared_ptr<const Mesh>>(shapes[i].shape),
                                  component.thickness);
            });
            completions[first + i] = std::move(draft.complete);
            kinds[first + i] = {
                .body = draft.body,
                .unit_radius = unit_radius_of(*draft.body),
                .weight = i == 0 ? component.weight : 0,
                .shapes = i == 0 ? static_cast<std::uint32_t>(shapes.size()) : 0,
                .spacing = component.spacing,
                .refine = component.refine,
                .rotation = component.rotation,
            };
        });
        prototypes.insert(prototypes.end(), shapes.begin(), shapes.end());
    }
}

} // namespace scree
