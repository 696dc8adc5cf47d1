// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of shapes that a script can name: meshes, curves, regions and fields.
#pragma once

#include "core/registry.h"
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/strands.h"
#include "geometry/plane/field.h"
#include "geometry/plane/region.h"

namespace scree {

/// Makes a component mesh from its checked parameters.
using MakeMesh = Mesh(const Params& params);

/// Makes strands from its checked parameters.
using MakeCurve = Strands(const Params& params);

/// Makes a region from its checked parameters.
using MakeRegion = Region(const Params& params);

/// Makes a field from its checked parameters.
using MakeField = std::shared_ptr<const Field>(const Params& params);

Registry<MakeMesh> component_table(); // mesh.banana, mesh.box, ... (mesh.file is in formats)
Registry<MakeCurve> curve_table();    // curve.polyline, curve.spline (curve.file is in formats)
Registry<MakeRegion> region_table();  // region.rectangle, region.polygon, ...
Registry<MakeField> field_table();    // field.image, field.function, ...

} // namespace scree
