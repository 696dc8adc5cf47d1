// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/texture_source.h"
#include "geometry/mesh/uv_raster.h"

namespace scree {

/// A procedural as a texture over its mesh's UVs: each covered texel holds the mean over what it
/// covers of the surface, all others the nearest covered one's. A normal is relative to the mesh's
/// `UvFrames`, x along u and y along v (OpenGL's way), and from [-1, 1] brought to [0, 1].
Image surface_texture(const TextureSource& source, const UvRaster& raster, TextureChannel channel,
                      const Context& context);

} // namespace scree
