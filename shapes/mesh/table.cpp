// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/component.h"

namespace scree {

Registry<MakeMesh> component_table() {
    Registry<MakeMesh> table("mesh");
    for (const auto& row :
         {plane_component,      box_component,     sphere_component, torus_component,
          cylinder_component,   cone_component,    block_component,  ring_component,
          pin_component,        star_component,    heart_component,  crescent_component,
          letter_component,     l_brick_component, jack_component,   duck_component,
          tree_component,       rice_component,    banana_component, chestnut_component,
          bolt_component,       nut_component,     gear_component,   sheet_component,
          cut_sphere_component, lathe_component,   text_component,   extrude_component,
          rock_component,       terrain_component})
        table.add(row());
    return table;
}

} // namespace scree
