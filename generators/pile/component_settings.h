// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/located.h"
#include "generators/pile/shape_variation.h"
#include "model/file_material.h"

#include <memory>
#include <optional>
#include <vector>

namespace scree {

/// One of a pile's components, as its parameters ask for it.
struct ComponentSettings {
    std::shared_ptr<const Mesh> shape;
    ParamPlace shape_place;
    Materials materials;
    double weight = 1;      // how often it is tried
    double thickness = 0;   // of a sheet [m]; 0: a closed mesh
    double spacing = 1;     // C_radius of Sakurai (2013)
    double refine = 2;      // C_refine
    Vec3 rotation{0, 0, 0}; // widths of the ranges of random angles about u, v and w [rad]
    std::optional<ShapeVariation> variation;
    ParamPlace bend_place; // of the variation
};

/// The components of generator.pile's parameters, with what these say for all components. Throws
/// Error, located, for a thickness of what is no sheet and for a variation that varies nothing.
std::vector<ComponentSettings> component_settings(const Params& params);

} // namespace scree
