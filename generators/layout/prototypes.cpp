// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/prototypes.h"

#include "geometry/plane/flat_mesh.h"
#include "geometry/plane/region_tools.h"

#include <fmt/format.h>

namespace scree {

namespace {

std::shared_ptr<const Region> own_region(const Params& component) {
    if (component.has("region"))
        return component.object<Region>("region");
    if (component.object<Mesh>("shape") == nullptr)
        return component.object<Region>("shape");
    try {
        return std::make_shared<Region>(silhouette(*component.object<Mesh>("shape")));
    } catch (const Error& error) {
        throw component.error("shape", error.diagnostics().front().message);
    }
}

std::shared_ptr<const Region> with_margin(const Params& component,
                                          std::shared_ptr<const Region> region) {
    const double margin = component.number("margin");
    if (margin == 0)
        return region;
    try {
        return std::make_shared<Region>(offset(*region, margin));
    } catch (const Error& error) {
        throw component.error("margin", error.diagnostics().front().message);
    }
}

} // namespace

Components components_from(const std::vector<Params>& components, Margins margins) {
    Components result;
    for (std::size_t i = 0; i < components.size(); ++i) {
        const Params& component = components[i];
        Prototype prototype;
        const std::shared_ptr<const Region> bare = own_region(component);
        if (!(area(*bare) > 0))
            throw component.error(component.has("region") ? "region" : "shape",
                                  "the region has no area");
        if (component.object<Mesh>("shape") != nullptr) {
            prototype.shape = component.object<Mesh>("shape");
        } else {
            prototype.shape = std::make_shared<Mesh>(
                flat_mesh(*component.object<Region>("shape"), fmt::format("component_{}", i)));
        }
        prototype.name = prototype.mesh()->name;
        if (margins == Margins::by_place && component.number("margin") < 0)
            throw component.error("margin", "is below 0; a margin that the layout's density "
                                            "multiplies can only grow the region");
        prototype.region = margins == Margins::by_place ? bare : with_margin(component, bare);
        prototype.material = component.object<Material>("material");
        result.prototypes.push_back(std::move(prototype));
        result.bare_areas.push_back(area(*bare));
    }
    return result;
}

} // namespace scree
