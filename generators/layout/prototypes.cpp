// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/prototypes.h"

#include "core/located.h"
#include "geometry/plane/flat_mesh.h"
#include "geometry/plane/region_tools.h"

#include <fmt/format.h>

namespace scree {

namespace {

std::shared_ptr<const Region> region_without_margin(const LayoutComponent& component) {
    if (component.given_region != nullptr)
        return component.given_region;
    if (component.mesh == nullptr)
        return component.flat_shape;
    return located(component.shape_place,
                   [&] { return std::make_shared<const Region>(silhouette(*component.mesh)); });
}

std::shared_ptr<const Region> with_margin(const LayoutComponent& component,
                                          std::shared_ptr<const Region> region) {
    if (component.margin == 0)
        return region;
    return located(component.margin_place, [&] {
        return std::make_shared<const Region>(offset(*region, component.margin));
    });
}

/// What is seen from above, where that is not the exclusive region; null for a mesh of which
/// nothing is.
std::shared_ptr<const Region> seen_outline(const LayoutComponent& component,
                                           const std::shared_ptr<const Region>& bare,
                                           const std::shared_ptr<const Region>& exclusive) {
    if (component.given_region == nullptr)
        return bare == exclusive ? nullptr : bare;
    if (component.mesh == nullptr)
        return component.flat_shape;
    try {
        return std::make_shared<const Region>(silhouette(*component.mesh));
    } catch (const Error& error) {
        if (error.fault() != Fault::input)
            throw;
        return nullptr;
    }
}

} // namespace

Components components_from(const std::vector<LayoutComponent>& components, Margins margins) {
    Components result;
    for (std::size_t i = 0; i < components.size(); ++i) {
        const LayoutComponent& component = components[i];
        const std::shared_ptr<const Region> bare = region_without_margin(component);
        if (!(area(*bare) > 0))
            throw component.region_place.error("the region has no area");
        if (margins == Margins::by_place && component.margin < 0)
            throw component.margin_place.error(
                "is below 0; a margin that the layout's density multiplies can only grow the "
                "region");
        Prototype prototype;
        prototype.shape = component.mesh != nullptr
                              ? component.mesh
                              : std::make_shared<const Mesh>(flat_mesh(
                                    *component.flat_shape, fmt::format("component_{}", i)));
        prototype.name = prototype.mesh()->name;
        prototype.region = margins == Margins::by_place ? bare : with_margin(component, bare);
        prototype.outline = seen_outline(component, bare, prototype.region);
        prototype.materials = component.materials;
        result.prototypes.push_back(std::move(prototype));
        result.bare_areas.push_back(area(*bare));
    }
    return result;
}

} // namespace scree
