// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/region/image_region.h"

#include "core/image_params.h"
#include "core/located.h"
#include "geometry/plane/image_channel.h"
#include "geometry/plane/image_outline.h"
#include "geometry/plane/region_tools.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

constexpr std::size_t max_outline_points = 500'000; // more take minutes to triangulate

/// The traced outlines in pixels, and the size of the image.
std::vector<Ring> traced(const Params& params, int& width, int& height) {
    const Image image = located(params, "path", [&] {
        return read_data_image(params.text("path"), image_options(params, "path"));
    });
    width = image.width;
    height = image.height;
    const bool opaque = params.text("channel") == "a" && !has_alpha(image);
    const std::string channel = opaque ? "luminance" : params.text("channel");
    std::vector<float> values =
        located(params, "channel", [&] { return channel_values(image, channel); });
    auto threshold = static_cast<float>(params.number("threshold"));
    if (params.flag("invert")) {
        threshold = -threshold;
        std::transform(values.begin(), values.end(), values.begin(), std::negate());
    }
    std::vector<Ring> rings =
        image_outlines({width, height, values}, threshold, params.number("min_area"));
    simplify_within(rings, params.number("tolerance"));
    std::size_t points = 0;
    for (const Ring& ring : rings)
        points += ring.size();
    if (points == 0)
        throw params.error("threshold",
                           fmt::format("nothing of the image is {} {} ({}), but for specks of less "
                                       "than min_area",
                                       params.flag("invert") ? "at most" : "at least",
                                       params.number("threshold"), channel));
    if (points > max_outline_points)
        throw params.error(
            "path",
            fmt::format("the outline has {} points, more than {}", points, max_outline_points),
            "give a larger tolerance or min_area");
    return rings;
}

Region image_region(const Params& params) {
    const bool whole = params.has("width") || params.has("depth");
    if (whole && params.has("size"))
        throw params.error("size", "stands beside width or depth, which also say how large it is",
                           "leave one of them out");
    int width = 0;
    int height = 0;
    std::vector<Ring> rings = traced(params, width, height);
    Vec2 origin(width / 2.0, height / 2.0);
    Vec2 pixel(0.0);
    if (whole) {
        pixel = {params.has("width") ? params.number("width") / width : 0,
                 params.has("depth") ? params.number("depth") / height : 0};
        pixel = {pixel.x > 0 ? pixel.x : pixel.y, pixel.y > 0 ? pixel.y : pixel.x};
    } else {
        Box2 box;
        for (const Ring& ring : rings)
            for (const Vec2& v : ring)
                box.extendBy(v);
        origin = box.center();
        const double size = params.has("size") ? params.number("size") : 1.0;
        pixel = Vec2(size / std::max(box.size().x, box.size().y));
    }
    for (Ring& ring : rings)
        for (Vec2& v : ring)
            v = (v - origin) * pixel;
    return located(params, "path", [&] { return triangulate(std::move(rings)); });
}

ParamSpec length(std::string name, std::string doc) {
    return optional_number_spec(std::move(name), std::move(doc), "m", 1e-6, 1e6);
}

} // namespace

Plugin<MakeRegion> image_region_plugin() {
    return {
        "image",
        "The outline of what is opaque in an image, or bright in one without alpha; the "
        "image's top row on the far side (-z).",
        {{.name = "path", .type = ParamType::path, .doc = "A PNG, JPEG, EXR or HDR."},
         layer_spec(),
         length("size", "Longest side of the outline, whose middle is moved to the origin; 1 m "
                        "when neither it nor width or depth is given."),
         length("width", "Of the whole image along x, its middle at the origin; from depth "
                         "with square pixels when not given."),
         length("depth", "Of the whole image along z; from width when not given."),
         {.name = "channel",
          .type = ParamType::choice,
          .doc = "Which channel to threshold, as stored; luminance for an image without alpha.",
          .fallback = std::string("a"),
          .choices = {"a", "luminance", "r", "g", "b"}},
         number_spec("threshold", "What a pixel inside has at least; between two, interpolated.",
                     "", 0.5, -1e9, 1e9),
         number_spec("tolerance", "How far the outline may be simplified.", "pixels", 0.5, 0, 100),
         number_spec("min_area", "Parts and holes of less are left out.", "square pixels", 4, 0,
                     1e9),
         {.name = "invert",
          .type = ParamType::boolean,
          .doc = "Takes the pixels below the threshold instead.",
          .fallback = false}},
        image_region};
}

} // namespace scree
