// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/plane/region.h"

#include <string>

namespace scree {

/// The region as a flat mesh at y = 0 that faces up. `uv_box` (x, z) becomes the UV square: u along
/// +x, v along -z, so that an image on it lies with its top row on the far side.
Mesh flat_mesh(const Region& region, std::string name, const Box2& uv_box);

/// The same with the region's bounding box.
Mesh flat_mesh(const Region& region, std::string name);

} // namespace scree
