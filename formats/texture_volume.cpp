// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/texture_volume.h"

#include "formats/texture_slices.h"

namespace scree {

namespace {

// The predicate of a volume's voxels in its slices; empty when it holds all of them.
HeldPixels held_pixels(const TextureVolume& volume, const SliceStack& stack) {
    if (volume.inside.empty())
        return {};
    return [&](int x, int y, int slice) {
        const VoxelGrid& grid = volume.grid;
        const Imath::V3d cell = (stack.centre(x, y, slice) - grid.corner) / grid.side;
        return volume.inside[grid.index(int(cell.x), int(cell.y), int(cell.z))] != 0;
    };
}

} // namespace

TextureVolume texture_volume(const Mesh& mesh, int longest) {
    TextureVolume volume;
    volume.grid = voxel_grid(mesh, longest);
    if (inspect(mesh).closed())
        volume.inside = voxels_inside(mesh, volume.grid);
    return volume;
}

std::vector<Image> volume_images(const TextureSource& source, const TextureVolume& volume, int axis,
                                 TextureChannel channel, const Context& context) {
    const SliceStack stack = slices_of(volume.grid, axis);
    return slice_images(source, stack, channel, held_pixels(volume, stack), context);
}

std::unique_ptr<VdbFile> volume_file(const TextureSource& source, const TextureVolume& volume,
                                     const WideMatrix& world_from_object, const Context& context) {
    Imath::M44d object_from_index;
    object_from_index.setScale(volume.grid.side);
    object_from_index[3][0] = volume.grid.centre(0, 0, 0).x;
    object_from_index[3][1] = volume.grid.centre(0, 0, 0).y;
    object_from_index[3][2] = volume.grid.centre(0, 0, 0).z;
    auto file = std::make_unique<VdbFile>(object_from_index * world_from_object);
    const SliceStack stack = slices_of(volume.grid, 2);
    const HeldPixels held = held_pixels(volume, stack);
    Context of_slice = context;
    of_slice.progress = {};
    for (int k = 0; k < stack.count; ++k) {
        context.report("texture", double(k) / stack.count);
        const std::vector<ShadingSample> samples = slice_samples(source, stack, k, held, of_slice);
        for (int j = 0; j < stack.height; ++j)
            for (int i = 0; i < stack.width; ++i) {
                const int y = stack.height - 1 - j; // row 0 is the top
                if (held && !held(i, y, k))
                    continue;
                const ShadingSample& sample =
                    samples[std::size_t(y) * std::size_t(stack.width) + std::size_t(i)];
                file->set(i, j, k, sample.value, sample.color);
            }
    }
    return file;
}

} // namespace scree
