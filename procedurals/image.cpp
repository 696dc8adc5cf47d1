// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/image.h"

#include "core/image_params.h"
#include "core/located.h"
#include "core/picture_filter.h"
#include "procedurals/reflectance.h"

#include <algorithm>
#include <optional>

namespace scree {

namespace {

// Below this alpha the premultiplied colour consists of rounding errors only (8 bits hold 1/255).
constexpr float least_alpha = 1.0F / 512;

class ImageTexture final : public Procedural {
  public:
    ImageTexture(const Image& image, Beyond beyond, std::optional<Color> ground)
        : filter_(image, beyond), ground_(ground) {}

    void evaluate(std::span<const ShadingPoint> points,
                  std::span<ShadingSample> samples) const override {
        for (std::size_t i = 0; i < points.size(); ++i)
            samples[i] = {color(Vec2(points[i].uv), double(points[i].uv_footprint)), 0.0F};
    }

  private:
    Color color(const Vec2& uv, double width) const {
        Rgba found = filter_.trilinear(uv, width);
        if (ground_) {
            const Color under = *ground_ * (1 - found[3]);
            return {found[0] + under.x, found[1] + under.y, found[2] + under.z};
        }
        // Coarser mip levels include opaque texels farther away.
        for (width = std::max(width, 1.0 / filter_.level(0).width);
             found[3] < least_alpha && width < 2; width *= 2)
            found = filter_.trilinear(uv, width);
        if (found[3] < least_alpha)
            return Color(0.0F);
        return {found[0] / found[3], found[1] / found[3], found[2] / found[3]};
    }

    PictureFilter filter_;
    std::optional<Color> ground_;
};

std::shared_ptr<const Procedural> make_image(const Params& params) {
    const Picture picture = located(params, "path", [&] {
        return read_picture(params.text("path"), static_cast<int>(params.integer("resolution")),
                            image_options(params, "path"));
    });
    std::optional<Color> ground;
    if (params.has("ground"))
        ground = reflectance(params, "ground");
    return std::make_shared<ImageTexture>(
        picture.image, params.flag("repeats") ? Beyond::repeated : Beyond::clamped, ground);
}

} // namespace

std::shared_ptr<const Procedural> picture_texture(const Picture& picture) {
    return std::make_shared<ImageTexture>(picture.image, Beyond::clamped, std::nullopt);
}

Plugin<MakeProcedural> image_plugin() {
    return {
        "image",
        "A picture over the UV square of a mesh, (0, 0) at its lower left, filtered over the "
        "pixel (Williams 1983).",
        {
            {.name = "path",
             .type = ParamType::path,
             .doc = "A PNG or JPEG (sRGB, or what its profile says, converted to linear), EXR or "
                    "HDR (linear), or SVG."},
            layer_spec(),
            {.name = "repeats",
             .type = ParamType::boolean,
             .doc = "Repeats beyond the UV square; otherwise the border pixels extend outwards.",
             .fallback = false},
            {.name = "ground",
             .type = ParamType::color,
             .doc = "Colour behind transparent parts; when not given they take the colours of "
                    "nearby opaque parts.",
             .optional = true},
            {.name = "resolution",
             .type = ParamType::integer,
             .doc = "Pixels along the longer side of an SVG.",
             .unit = "pixels",
             .fallback = std::int64_t{1024},
             .min = 16.0,
             .max = 8192.0},
        },
        make_image,
    };
}

} // namespace scree
