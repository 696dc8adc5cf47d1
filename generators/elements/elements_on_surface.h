// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/elements/element_shapes.h"

namespace scree {

/// Throws Error, located, for what only a flat domain has: fields, torus, background.
void check_surface_settings(const ElementsSettings& settings);

/// Elements that stand on the settings' surface: their y axes point along its normals, the smooth
/// ones where it has such. Throws Error, located, for a mesh without a surface.
Aggregate bake_on_surface(const ElementsSettings& settings, const std::vector<ElementShape>& shapes,
                          const Context& context);

} // namespace scree
