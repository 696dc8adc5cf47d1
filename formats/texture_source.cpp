// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/texture_source.h"

#include "core/parallel.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

// Points per block: enough to keep a device busy, about 25 MB.
constexpr std::size_t block_size = std::size_t{1} << 18;

/// From units of the object to metres of the world.
void take_to_metres(ShadingPoint& point, const Vec3& stretch) {
    const float footprint = point.across.length();
    point.position *= stretch;
    point.across *= stretch;
    point.along *= stretch;
    if (footprint > 0)
        point.footprint *= point.across.length() / footprint;
}

} // namespace

std::vector<std::string> channel_names(TextureChannel channel) {
    if (channel == TextureChannel::color || channel == TextureChannel::normal)
        return {"R", "G", "B"};
    return {"Y"};
}

void put_channel(TextureChannel channel, const ShadingSample& sample, float* pixel) {
    switch (channel) {
    case TextureChannel::color:
        std::copy_n(&sample.color.x, 3, pixel);
        break;
    case TextureChannel::height:
        *pixel = sample.height;
        break;
    case TextureChannel::roughness:
        *pixel = sample.roughness;
        break;
    case TextureChannel::value:
        *pixel = sample.value;
        break;
    case TextureChannel::normal:
        assert(!"a normal needs the mesh's UV frame");
    }
}

void TextureSource::evaluate(std::size_t count,
                             const std::function<ShadingPoint(std::size_t)>& place,
                             const std::function<void(std::size_t, const ShadingSample&)>& take,
                             const Context& context) const {
    std::vector<ShadingPoint> points(std::min(count, block_size));
    std::vector<ShadingSample> samples(points.size());
    for (std::size_t first = 0; first < count; first += block_size) {
        context.check_cancel();
        context.report("texture", double(first) / double(count));
        const std::size_t size = std::min(block_size, count - first);
        parallel_for(size, 256, [&](std::size_t i) {
            points[i] = place(first + i);
            points[i].random = random;
            if (!procedural->scales_with_object())
                take_to_metres(points[i], stretch);
        });
        procedural->bake({points.data(), size}, {samples.data(), size}, device);
        parallel_for(size, 256, [&](std::size_t i) {
            if (samples[i].roughness == ShadingSample::unset)
                samples[i].roughness = roughness;
            take(first + i, samples[i]);
        });
    }
}

} // namespace scree
