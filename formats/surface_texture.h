// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/texture_source.h"
#include "geometry/mesh/uv_raster.h"

namespace scree {

/// Bakes a procedural to a texture over the mesh's UVs. Each covered texel holds the filtered value
/// of its part of the surface; all others copy the nearest covered texel. Normals are in the
/// tangent frames of the mesh's `UvFrames`, x along u and y along v (OpenGL convention), mapped
/// from [-1, 1] to [0, 1].
Image surface_texture(const TextureSource& source, const UvRaster& raster, TextureChannel channel,
                      const Context& context);

} // namespace scree
