// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/layout_picture.h"
#include "scenes/reader/scene.h"

namespace scree {

/// The colour of an element in a drawing: its material's own where that is one colour, or one of a
/// palette; where it is glass or comes from a procedural, the component's of `palette_color`.
/// `scene` must outlive the result.
ElementColor layout_colors(const Scene& scene);

} // namespace scree
