// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/texture_slices.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

// A thick slice is the mean of this many cuts. ShadingPoint filters over two directions only; the
// mean over the third cancels the first three harmonics of the voxels' sampling frequency.
constexpr int cuts_per_slice = 4;

constexpr int gap = 4; // between the pictures of a contact sheet [pixels]

struct Axes {
    Vec3d right, down;
};

// The cross product of right and up is the axis, so that the axis points to the viewer.
Axes axes_across(int axis) {
    static const std::array<Axes, 3> table{
        {{{0, 0, -1}, {0, -1, 0}}, {{1, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, -1, 0}}}};
    return table[std::size_t(axis)];
}

Vec3d unit_vector(int axis) {
    Vec3d out(0.0);
    out[axis] = 1;
    return out;
}

double along(const Vec3d& direction, const Vec3d& size) { return std::abs(direction.dot(size)); }

// Sets the stack's first pixel and steps so that its pixels fill a box of size `extent` about
// `centre`.
void place(SliceStack& stack, const Vec3d& centre, const Vec3d& extent) {
    const Axes axes = axes_across(stack.axis);
    const Vec3d towards = unit_vector(stack.axis);
    stack.right = axes.right * (along(axes.right, extent) / stack.width);
    stack.down = axes.down * (along(axes.down, extent) / stack.height);
    stack.step = towards * (along(towards, extent) / stack.count);
    stack.first = centre - stack.right * ((stack.width - 1) / 2.0) -
                  stack.down * ((stack.height - 1) / 2.0) - stack.step * ((stack.count - 1) / 2.0);
}

void add(ShadingSample& sum, const ShadingSample& sample, float share) {
    sum.color += sample.color * share;
    sum.height += sample.height * share;
    sum.slope += sample.slope * share;
    sum.roughness += sample.roughness * share;
    sum.value += sample.value * share;
}

} // namespace

SliceStack slices_through(const Mesh& mesh, int axis, int count, int width, int height) {
    const Box3 box = bounds(mesh);
    Vec3d extent(mesh.positions.empty() ? Vec3(0.0F) : box.size());
    const Axes axes = axes_across(axis);
    const double wide = along(axes.right, extent), high = along(axes.down, extent);
    const double longer = std::max(wide, high);
    if (!(longer > 0))
        throw Error("has no extent across the axis");
    SliceStack stack;
    stack.axis = axis;
    stack.count = count;
    stack.width = width;
    stack.height = height;
    if (height == 0) {
        const auto pixels = [&](double length) {
            return std::max(1, static_cast<int>(std::lround(length / longer * width)));
        };
        stack.height = pixels(high);
        stack.width = pixels(wide);
    }
    place(stack, Vec3d(box.center()), extent);
    return stack;
}

SliceStack slices_of(const VoxelGrid& grid, int axis) {
    const Axes axes = axes_across(axis);
    const Vec3d counts(grid.count[0], grid.count[1], grid.count[2]);
    const auto voxels = [&](const Vec3d& direction) {
        return static_cast<int>(std::lround(along(direction, counts)));
    };
    SliceStack stack;
    stack.axis = axis;
    stack.width = voxels(axes.right);
    stack.height = voxels(axes.down);
    stack.count = grid.count[std::size_t(axis)];
    stack.thick = true;
    place(stack, grid.corner + counts * (grid.side / 2), counts * grid.side);
    return stack;
}

std::vector<ShadingSample> slice_samples(const TextureSource& source, const SliceStack& stack,
                                         int slice, const HeldPixels& held,
                                         const Context& context) {
    const int cuts = stack.thick ? cuts_per_slice : 1;
    const auto share = 1 / static_cast<float>(cuts);
    ShadingPoint point;
    const bool wide = stack.right.length2() > stack.down.length2();
    point.across = Vec3(wide ? stack.down : stack.right);
    point.along = Vec3(wide ? stack.right : stack.down);
    point.footprint = point.across.length();

    ShadingSample nothing;
    nothing.roughness = 0;
    std::vector<ShadingSample> samples(std::size_t(stack.width) * std::size_t(stack.height),
                                       nothing);
    struct Pixel {
        int x, y;
        std::size_t index;
    };
    std::vector<Pixel> pixels;
    for (int y = 0; y < stack.height; ++y)
        for (int x = 0; x < stack.width; ++x)
            if (!held || held(x, y, slice))
                pixels.push_back(
                    {x, y, std::size_t(y) * std::size_t(stack.width) + std::size_t(x)});
    for (int cut = 0; cut < cuts; ++cut) {
        const Vec3d offset = stack.step * ((cut + 0.5) / cuts - 0.5);
        source.evaluate(
            pixels.size(),
            [&](std::size_t i) {
                ShadingPoint here = point;
                here.position = Vec3(stack.centre(pixels[i].x, pixels[i].y, slice) + offset);
                return here;
            },
            [&](std::size_t i, const ShadingSample& sample) {
                add(samples[pixels[i].index], sample, share);
            },
            context);
    }
    return samples;
}

std::vector<Image> slice_images(const TextureSource& source, const SliceStack& stack,
                                TextureChannel channel, const HeldPixels& held,
                                const Context& context) {
    Context of_slice = context;
    of_slice.progress = {};
    std::vector<std::string> names = channel_names(channel);
    if (held)
        names.emplace_back("A");
    std::vector<Image> images;
    for (int slice = 0; slice < stack.count; ++slice) {
        context.report("texture", double(slice) / stack.count);
        const std::vector<ShadingSample> samples =
            slice_samples(source, stack, slice, held, of_slice);
        Image image(stack.width, stack.height, names);
        for (int y = 0; y < stack.height; ++y)
            for (int x = 0; x < stack.width; ++x) {
                if (held && !held(x, y, slice))
                    continue;
                float* pixel = image.at(x, y);
                put_channel(channel,
                            samples[std::size_t(y) * std::size_t(stack.width) + std::size_t(x)],
                            pixel);
                if (held)
                    pixel[names.size() - 1] = 1;
            }
        images.push_back(std::move(image));
    }
    return images;
}

std::string slice_name(const SliceStack& stack, int slice) {
    const int digits = static_cast<int>(std::to_string(stack.count).size());
    return fmt::format("slice_{:0{}}_{}_{:.5g}", slice + 1, digits, "xyz"[stack.axis],
                       stack.position(slice));
}

Image contact_sheet(std::span<const Image> slices) {
    const int width = slices.front().width, height = slices.front().height;
    const int count = static_cast<int>(slices.size());
    // The number of columns that makes the sheet about square.
    const double square = std::sqrt(double(count) * (height + gap) / (width + gap));
    const int columns = std::clamp(static_cast<int>(std::lround(square)), 1, count);
    const int rows = (count + columns - 1) / columns;
    Image sheet(columns * (width + gap) - gap, rows * (height + gap) - gap,
                slices.front().channels);
    std::fill(sheet.pixels.begin(), sheet.pixels.end(), 1.0F);
    for (int i = 0; i < count; ++i)
        for (int y = 0; y < height; ++y) {
            const Image& slice = slices[std::size_t(i)];
            std::copy_n(slice.at(0, y), std::size_t(width) * slice.channels.size(),
                        sheet.at(i % columns * (width + gap), i / columns * (height + gap) + y));
        }
    return sheet;
}

} // namespace scree
