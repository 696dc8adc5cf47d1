// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/picture_shape.h"

#include "core/image_params.h"
#include "core/located.h"
#include "geometry/plane/flat_mesh.h"
#include "geometry/plane/image_channel.h"
#include "geometry/plane/image_outline.h"
#include "geometry/plane/region_tools.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

constexpr float opaque = 0.5F;
constexpr double least_area = 4;             // [square pixels], the default of region.image
constexpr std::size_t most_points = 500'000; // some seconds to triangulate

// Detail finer than half a pixel is noise, and a thousandth of a large picture is not visible.
double tolerance(const Image& image) {
    return std::max(0.5, 0.001 * std::max(image.width, image.height));
}

std::vector<Ring> outline_in_pixels(const Image& image) {
    const std::vector<float> alpha = channel_values(image, "a");
    std::vector<Ring> rings =
        image_outlines({image.width, image.height, alpha}, opaque, least_area);
    simplify_within(rings, tolerance(image));
    std::size_t points = 0;
    for (const Ring& ring : rings)
        points += ring.size();
    if (points == 0)
        throw Error("nothing of the picture is opaque, but for specks");
    if (points > most_points)
        throw Error(
            fmt::format("the picture's outline has {} points, more than {}", points, most_points));
    return rings;
}

} // namespace

PictureShape picture_shape(Picture picture, double size) {
    std::vector<Ring> rings = outline_in_pixels(picture.image);
    Box2 outline;
    for (const Ring& ring : rings)
        for (const Vec2& v : ring)
            outline.extendBy(v);
    const Vec2 pixels(double(picture.image.width), double(picture.image.height));
    // A drawing's raster is rounded to whole pixels, its box is not.
    const Vec2 side = picture.box.size() / pixels;
    const Vec2 extent = outline.size() * side;
    const Vec2 scale = side * (size / std::max(extent.x, extent.y));
    const auto on_ground = [&](const Vec2& v) { return (v - outline.center()) * scale; };
    for (Ring& ring : rings)
        for (Vec2& v : ring)
            v = on_ground(v);
    picture.box = {on_ground(Vec2(0.0)), on_ground(pixels)};
    PictureShape shape;
    shape.region = std::make_shared<Region>(triangulate(std::move(rings)));
    shape.mesh = std::make_shared<Mesh>(flat_mesh(*shape.region, picture.name, picture.box));
    shape.picture = std::make_shared<Picture>(std::move(picture));
    return shape;
}

std::vector<ParamSpec> picture_specs() {
    return {
        {.name = "picture",
         .type = ParamType::path,
         .doc =
             "A PNG, JPEG, EXR, HDR or SVG that is shape, outline and looks at once: the shape is "
             "where its alpha is at least a half.",
         .optional = true},
        layer_spec(),
        {.name = "size",
         .type = ParamType::number,
         .doc = "Longest side of the picture's outline.",
         .unit = "m",
         .optional = true,
         .min = 1e-6,
         .max = 1e6},
        {.name = "resolution",
         .type = ParamType::integer,
         .doc = "Pixels along the longer side of a picture that is an SVG, for its outline and "
                "wherever it is shown as pixels.",
         .unit = "pixels",
         .fallback = std::int64_t{drawing_pixels},
         .min = 16.0,
         .max = 8192.0},
    };
}

PictureShape picture_shape(const Params& component) {
    if (!component.has("size"))
        throw component.error("size", "is missing: how long a picture is on the ground",
                              "for example size = mm(40)");
    return located(component, "picture", [&] {
        return picture_shape(read_picture(component.text("picture"),
                                          static_cast<int>(component.integer("resolution")),
                                          image_options(component, "picture")),
                             component.number("size"));
    });
}

} // namespace scree
