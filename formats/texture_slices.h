// SPDX-License-Identifier: GPL-3.0-or-later
// Slices of solid procedurals: pictures of parallel cuts, and the layers of voxel volumes.
#pragma once

#include "formats/texture_source.h"
#include "geometry/mesh/voxel_grid.h"

#include <span>

namespace scree {

/// Parallel cuts perpendicular to an axis, which points to the viewer: for x, y is up; for y, x is
/// to the right; for z, y is up. Lengths are in object space [m].
struct SliceStack {
    int axis = 2;                    // x, y or z
    Imath::V3d first{0.0, 0.0, 0.0}; // centre of the first slice's top left pixel
    Imath::V3d right{1.0, 0.0, 0.0}; // from one pixel to the next
    Imath::V3d down{0.0, -1.0, 0.0};
    Imath::V3d step{0.0, 0.0, 1.0}; // from one slice to the next
    int width = 1;
    int height = 1;
    int count = 1;
    bool thick = false; // each slice is the mean over `step`, otherwise an infinitely thin cut

    Imath::V3d centre(int x, int y, int slice) const {
        return first + right * double(x) + down * double(y) + step * double(slice);
    }
    double position(int slice) const { return centre(0, 0, slice)[axis]; }
};

/// Cuts through the middles of `count` equal slabs of the mesh's bounding box, of `width` by
/// `height` pixels. With a height of 0 the pixels are square and the longer side has `width` of
/// them. Throws Error (input) for a mesh without extent perpendicular to the axis.
SliceStack slices_through(const Mesh& mesh, int axis, int count, int width, int height);

/// The layers of a voxel grid along an axis.
SliceStack slices_of(const VoxelGrid& grid, int axis);

/// Whether a pixel is evaluated; empty: all are.
using HeldPixels = std::function<bool(int x, int y, int slice)>;

/// The samples of one slice, row by row from the top; all 0 where `held` is false.
std::vector<ShadingSample> slice_samples(const TextureSource& source, const SliceStack& stack,
                                         int slice, const HeldPixels& held, const Context& context);

/// All slices as pictures of a channel other than the normal. With `held` they have a channel A,
/// which is 1 where `held` is true; elsewhere all channels are 0.
std::vector<Image> slice_images(const TextureSource& source, const SliceStack& stack,
                                TextureChannel channel, const HeldPixels& held,
                                const Context& context);

/// "slice_007_z_0.0125": the slice's number from 1 and its coordinate on the axis [m].
std::string slice_name(const SliceStack& stack, int slice);

/// Combines pictures of equal size into one, row by row, with white gaps between them.
Image contact_sheet(std::span<const Image> slices);

} // namespace scree
