// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/surface_texture.h"

#include "geometry/mesh/uv_frame.h"
#include "geometry/mesh/uv_gutter.h"

#include <cmath>
#include <optional>

namespace scree {

namespace {

ShadingPoint shading_point(const Mesh& mesh, const UvRaster& raster, std::uint32_t texel) {
    const TexelPlace place = raster.place(texel);
    const Mesh::Triangle& t = mesh.triangles[place.triangle];
    const Vec3& a = mesh.positions[t[0]];
    ShadingPoint point;
    point.position = place.position;
    point.level = place.position.y;
    point.up = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).normalized().y;
    point.footprint = place.across.length();
    point.uv = place.uv;
    point.uv_footprint =
        static_cast<float>(1 / std::sqrt(double(raster.width()) * raster.height()));
    point.across = place.across;
    point.along = place.along;
    return point;
}

// The normal of the surface displaced by the height, in the tangent frame: n minus the surface
// gradient (Mikkelsen 2010).
Vec3 bent_normal(const UvAxes& axes, const Vec3& slope) {
    return Vec3(-slope.dot(axes.tangent), -slope.dot(axes.bitangent), 1.0F).normalized();
}

} // namespace

Image surface_texture(const TextureSource& source, const UvRaster& raster, TextureChannel channel,
                      const Context& context) {
    Image image(raster.width(), raster.height(), channel_names(channel));
    const std::vector<std::uint32_t>& texels = raster.covered_texels();
    std::optional<UvFrames> frames;
    if (channel == TextureChannel::normal)
        frames.emplace(*source.mesh);
    source.evaluate(
        texels.size(),
        [&](std::size_t i) { return shading_point(*source.mesh, raster, texels[i]); },
        [&](std::size_t i, const ShadingSample& sample) {
            float* pixel = &image.pixels[texels[i] * image.channels.size()];
            if (!frames)
                return put_channel(channel, sample, pixel);
            const TexelPlace place = raster.place(texels[i]);
            const Vec3 normal =
                bent_normal(frames->at(place.triangle, place.barycentric), sample.slope);
            for (int c = 0; c < 3; ++c)
                pixel[c] = 0.5F + 0.5F * normal[c];
        },
        context);
    std::vector<bool> covered(raster.width() * std::size_t(raster.height()));
    for (const std::uint32_t texel : texels)
        covered[texel] = true;
    fill_gutter(image, covered);
    return image;
}

} // namespace scree
