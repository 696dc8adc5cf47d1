// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/texture_source.h"
#include "formats/write_vdb.h"
#include "geometry/mesh/voxel_grid.h"

namespace scree {

/// The voxels of a volume texture.
struct TextureVolume {
    VoxelGrid grid;
    std::vector<std::uint8_t> inside; // indexed by VoxelGrid::index; empty: all
};

/// The voxels of the mesh's bounding box, `longest` along its longest side. If the mesh is closed
/// (every edge joins two consistently oriented triangles), only voxels with their centre inside it
/// are held. Throws Error (input) for a mesh without extent.
TextureVolume texture_volume(const Mesh& mesh, int longest);

/// The layers along an axis, laid out as slices_of(volume.grid, axis); with a channel A when not
/// all voxels are held.
std::vector<Image> volume_images(const TextureSource& source, const TextureVolume& volume, int axis,
                                 TextureChannel channel, const Context& context);

/// An OpenVDB file with the grids `density` (ShadingSample::value) and `color`, in world space.
std::unique_ptr<VdbFile> volume_file(const TextureSource& source, const TextureVolume& volume,
                                     const WideMatrix& world_from_object, const Context& context);

} // namespace scree
