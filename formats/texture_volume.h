// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/texture_source.h"
#include "formats/write_vdb.h"
#include "geometry/mesh/voxel_grid.h"

namespace scree {

/// The voxels of a mesh that a volume holds.
struct TextureVolume {
    VoxelGrid grid;
    std::vector<std::uint8_t> inside; // by VoxelGrid::index; empty: all
};

/// Those with their centre inside the mesh where it is closed (every edge between two triangles
/// that agree which side is out), otherwise all of its bounding box; `longest` of them along the
/// longest side. Throws Error (input) for a mesh without extent.
TextureVolume texture_volume(const Mesh& mesh, int longest);

/// Layer by layer along an axis, as slices_of(volume.grid, axis) lies; with an A where not all
/// voxels are held.
std::vector<Image> volume_images(const TextureSource& source, const TextureVolume& volume, int axis,
                                 TextureChannel channel, const Context& context);

/// The grids `density` (ShadingSample::value) and `color` of the voxels, in place in the world.
std::unique_ptr<VdbFile> volume_file(const TextureSource& source, const TextureVolume& volume,
                                     const Matrix& world_from_object, const Context& context);

} // namespace scree
