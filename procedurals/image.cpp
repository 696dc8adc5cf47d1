// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/image.h"

#include "core/image_params.h"
#include "core/located.h"
#include "core/picture.h"
#include "model/picture_texture.h"
#include "procedurals/reflectance.h"

namespace scree {

namespace {

std::shared_ptr<const Procedural> make_image(const Params& params) {
    const Picture picture = located(params, "path", [&] {
        return read_picture(params.text("path"), static_cast<int>(params.integer("resolution")),
                            image_options(params, "path"));
    });
    PictureLook look;
    if (params.has("ground"))
        look.ground = reflectance(params, "ground");
    const Vec2& copies = params.vector2("copies");
    if (!(copies.x > 0 && copies.y > 0))
        throw params.error("copies", "must be above 0");
    if (!params.flag("repeats") && (copies.x > 1 || copies.y > 1))
        throw params.error("copies", "are more than one", "expected repeats = true beside it");
    look.picture_from_uv.setScale(copies);
    const Beyond beyond = params.flag("repeats") ? Beyond::repeated : Beyond::clamped;
    return picture_texture(std::make_shared<const PictureFilter>(picture.image, beyond), look);
}

} // namespace

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
            {.name = "copies",
             .type = ParamType::vector2,
             .doc = "How many copies of the picture lie side by side over the UV square, along u "
                    "and v; more than 1 need repeats; below 1: the lower left part of one.",
             .fallback = Vec2(1, 1),
             .pair = "{u, v}"},
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
