// SPDX-License-Identifier: GPL-3.0-or-later
// Procedurals as cuts through space: pictures of slices, and volumes of voxels.
#pragma once

#include "formats/texture_source.h"
#include "geometry/mesh/voxel_grid.h"

#include <span>

namespace scree {

/// Parallel cuts, seen from where their axis points to: across x from +x with y up, across y from
/// +y with x to the right, across z from +z with y up. Lengths in the object's frame [m].
struct SliceStack {
    int axis = 2;                    // x, y or z
    Imath::V3d first{0.0, 0.0, 0.0}; // centre of the first slice's top left pixel
    Imath::V3d right{1.0, 0.0, 0.0}; // from one pixel to the next
    Imath::V3d down{0.0, -1.0, 0.0};
    Imath::V3d step{0.0, 0.0, 1.0}; // from one slice to the next
    int width = 1;
    int height = 1;
    int count = 1;
    bool thick = false; // each slice is the mean over its `step`, otherwise a cut

    Imath::V3d centre(int x, int y, int slice) const {
        return first + right * double(x) + down * double(y) + step * double(slice);
    }
    double position(int slice) const { return centre(0, 0, slice)[axis]; }
};

/// The cuts through the middles of `count` equal slabs of the mesh's bounding box. `width` by
/// `height` pixels; with a height of 0 they are square, `width` of them along the longer side.
/// Throws Error (input) for a mesh without extent across the axis.
SliceStack slices_through(const Mesh& mesh, int axis, int count, int width, int height);

/// A grid's voxels, layer by layer along an axis.
SliceStack slices_of(const VoxelGrid& grid, int axis);

/// Which pixels are wanted; empty: all.
using HeldPixels = std::function<bool(int x, int y, int slice)>;

/// One slice's samples, row by row from the top; all 0 where `held` says no.
std::vector<ShadingSample> slice_samples(const TextureSource& source, const SliceStack& stack,
                                         int slice, const HeldPixels& held, const Context& context);

/// All slices as pictures, `channel` not being the normal. With `held` they have an A that is 1
/// where it says yes, and 0 in all channels elsewhere.
std::vector<Image> slice_images(const TextureSource& source, const SliceStack& stack,
                                TextureChannel channel, const HeldPixels& held,
                                const Context& context);

/// "slice_007_z_0.0125": the slice's number from 1 and where it cuts the axis [m].
std::string slice_name(const SliceStack& stack, int slice);

/// Pictures of one size on one sheet, row by row, with white gaps between them.
Image contact_sheet(std::span<const Image> slices);

} // namespace scree
