// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by all component meshes: declaration, parameters and placement on the ground.
#pragma once

#include "shapes/table.h"

namespace scree {

/// A component plug-in. `shape` may build its mesh anywhere: the mesh is translated so that its
/// bounding box is centred on the y axis and its lowest point lies at y = 0, as is added to `doc`,
/// and is named after the component.
Plugin<MakeMesh> component(std::string name, std::string doc, std::vector<ParamSpec> params,
                           std::function<MakeMesh> shape);

/// A length in metres, 0.1 mm to 100 m.
ParamSpec metres(std::string name, std::string doc, double fallback);

/// An optional length in metres, whose default depends on other parameters.
ParamSpec optional_metres(std::string name, std::string doc);

/// A number in [min, max], without unit.
ParamSpec ratio(std::string name, std::string doc, double fallback, double min, double max);

/// An angle; `fallback`, `min` and `max` are in degrees, the shape gets radians.
ParamSpec angle_degrees(std::string name, std::string doc, double fallback, double min, double max);

/// A count in [min, max].
ParamSpec count(std::string name, std::string doc, int fallback, int min, int max);

/// The value of an optional length, or `otherwise` when it is not given.
double number_or(const Params& params, const std::string& name, double otherwise);

Plugin<MakeMesh> plane_component();
Plugin<MakeMesh> box_component();
Plugin<MakeMesh> block_component();

Plugin<MakeMesh> sphere_component();
Plugin<MakeMesh> torus_component();
Plugin<MakeMesh> cylinder_component();
Plugin<MakeMesh> cone_component();
Plugin<MakeMesh> ring_component();
Plugin<MakeMesh> pin_component();
Plugin<MakeMesh> cut_sphere_component();
Plugin<MakeMesh> lathe_component();

Plugin<MakeMesh> rice_component();
Plugin<MakeMesh> banana_component();
Plugin<MakeMesh> chestnut_component();

Plugin<MakeMesh> bolt_component();
Plugin<MakeMesh> nut_component();
Plugin<MakeMesh> gear_component();

Plugin<MakeMesh> l_brick_component();
Plugin<MakeMesh> star_component();
Plugin<MakeMesh> heart_component();
Plugin<MakeMesh> crescent_component();
Plugin<MakeMesh> letter_component();
Plugin<MakeMesh> text_component();

Plugin<MakeMesh> sheet_component();
Plugin<MakeMesh> extrude_component();

Plugin<MakeMesh> jack_component();
Plugin<MakeMesh> duck_component();
Plugin<MakeMesh> tree_component();
Plugin<MakeMesh> rock_component();
Plugin<MakeMesh> terrain_component();

} // namespace scree
