// SPDX-License-Identifier: GPL-3.0-or-later
// Materials that a mesh's file brings.
#pragma once

#include "geometry/mesh/mesh.h"
#include "model/material.h"

namespace scree {

/// The declaration of an optional parameter `material` of what has a shape: a material, or "file"
/// for those of the shape's file. `doc` is its description without a full stop.
ParamSpec shape_material_spec(const std::string& doc);

/// What that parameter says for a shape (null: not a mesh). With "file" it warns of what the file
/// says of its materials and is not honoured. Throws the parameter's Error when the shape is from
/// no file, or from one without materials, or a picture cannot be read.
Materials materials_of(const Params& params, const Mesh* shape);

} // namespace scree
