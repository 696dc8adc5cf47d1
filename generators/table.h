// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "core/registry.h"

namespace scree {

/// A generator bakes an aggregate. Its parameters are already checked against its specs; it throws
/// `Params::error` for what only it can know (a region larger than the domain).
using Bake = Aggregate(const Params& params, const Context& context);

/// Makes a component mesh from its checked parameters.
using MakeMesh = Mesh(const Params& params);

/// Makes a region from its checked parameters.
using MakeRegion = Region(const Params& params);

/// Makes a field from its checked parameters.
using MakeField = std::shared_ptr<const Field>(const Params& params);

Registry<Bake> generator_table();     // generator.layout, ...
Registry<MakeMesh> component_table(); // mesh.banana, mesh.box, ... (mesh.file is in formats)
Registry<MakeRegion> region_table();  // region.rectangle, region.polygon, ...
Registry<MakeField> field_table();    // field.image, field.function, ...

} // namespace scree
