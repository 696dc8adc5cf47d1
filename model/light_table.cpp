// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/table.h"

#include "core/image_params.h"
#include "core/located.h"
#include "model/table_tools.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

// A picture of all directions; one of another form would be stretched over them.
std::shared_ptr<const Image> sky_image(const Params& params) {
    const std::string& path = params.text("image");
    const ImageOptions options = image_options(params, "image");
    auto image = located(params, "image",
                         [&] { return std::make_shared<Image>(read_image(path, options)); });
    const std::string size =
        fmt::format("{}: is {} x {} pixels", path, image->width, image->height);
    if (image->height > image->width)
        throw params.error("image", size + "; a latitude-longitude image is twice as wide as high");
    constexpr double cut_off = 0.01; // a row or a column does not show
    if (std::abs(image->width - 2.0 * image->height) > cut_off * image->width)
        params.warn("image",
                    size +
                        " and is stretched: a latitude-longitude image is twice as wide as high");
    for (const float value : image->pixels)
        if (value >= 1e30F)
            throw params.error("image", path + ": holds a radiance of 1e30 or more");
    return image;
}

ParamSpec group_spec() {
    return {.name = "group",
            .type = ParamType::text,
            .doc = "Group of lights whose share of the picture is written to the .exr as a part of "
                   "its own, light_GROUP; lights without one are group rest then.",
            .optional = true};
}

// The name becomes part of a name in the .exr, where a dot separates layers from channels.
std::string group_of(const Params& params) {
    if (!params.has("group"))
        return {};
    const std::string& name = params.text("group");
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    };
    constexpr std::size_t longest = 64;
    if (name.empty() || name.size() > longest || !std::ranges::all_of(name, allowed))
        throw params.error("group", "must be 1 to 64 letters, digits, _ and -");
    return name;
}

Plugin<MakeLight> sky_plugin() {
    ParamSpec horizon =
        color_spec("horizon", "Radiance at the horizon; that of color when not given.");
    ParamSpec zenith =
        color_spec("zenith", "Radiance at the zenith; that of color when not given.");
    ParamSpec ground =
        color_spec("ground", "Radiance below the horizon; that of horizon when not given.");
    for (ParamSpec* spec : {&horizon, &zenith, &ground}) {
        spec->fallback = {};
        spec->optional = true;
    }
    return {
        "sky",
        "Light from all directions: one colour, a vertical gradient, or an image.",
        {color_spec("color", "Radiance in every direction."),
         zenith,
         horizon,
         ground,
         {.name = "image",
          .type = ParamType::path,
          .doc = "A latitude-longitude image (HDR, EXR, PNG or JPEG), multiplied by color, twice "
                 "as wide as high; its top row is the zenith, its centre lies in direction "
                 "-z, the middle of its right half in +x.",
          .optional = true},
         layer_spec(),
         {.name = "rotation",
          .type = ParamType::number,
          .doc = "Rotation about the y axis, counter-clockwise seen from above.",
          .unit = "deg",
          .fallback = 0.0,
          .min = -360.0,
          .max = 360.0},
         strength_spec(1.0, "Factor on all radiances.", ""),
         group_spec()},
        [](const Params& params) -> Light {
            Sky sky;
            const auto color = [&](const char* name, const Color& otherwise) {
                if (!params.has(name))
                    return otherwise;
                check_color(params, name, params.color(name), max_radiance);
                return params.color(name);
            };
            const Color base = color("color", Color(1.0F, 1.0F, 1.0F));
            sky.zenith = color("zenith", base);
            sky.horizon = color("horizon", base);
            sky.ground = color("ground", sky.horizon);
            sky.rotation = float_number(params, "rotation");
            sky.strength = float_number(params, "strength");
            sky.group = group_of(params);
            if (params.has("image")) {
                for (const char* name : {"zenith", "horizon", "ground"})
                    if (params.has(name))
                        throw params.error(name, "cannot be given together with image");
                sky.image = sky_image(params);
            }
            return sky;
        }};
}

Plugin<MakeLight> sun_plugin() {
    return {"sun",
            "A distant disk of light.",
            {{.name = "direction",
              .type = ParamType::vector3,
              .doc = "Direction towards the sun, of any length.",
              .fallback = Vec3(1.0F, 2.0F, 1.0F)},
             {.name = "angle",
              .type = ParamType::number,
              .doc = "Angular diameter; a larger one gives softer shadows.",
              .unit = "deg",
              .fallback = 0.53,
              .min = 0.01,
              .max = 90.0},
             color_spec("color", "Colour of the light."),
             strength_spec(3.0, "Irradiance on a surface that faces the sun.", "W/m^2"),
             group_spec()},
            [](const Params& params) -> Light {
                Sun sun{params.vector3("direction"), float_number(params, "angle"),
                        params.color("color"), float_number(params, "strength"), group_of(params)};
                check_color(params, "color", sun.color, max_radiance);
                if (!(is_finite(sun.direction) && sun.direction.length() > 0))
                    throw params.error("direction", "must not be zero");
                sun.direction.normalize();
                return sun;
            }};
}

Plugin<MakeLight> area_plugin() {
    return {"area",
            "A visible rectangle that emits light from its front.",
            {{.name = "position",
              .type = ParamType::point3,
              .doc = "Centre of the rectangle.",
              .unit = "m",
              .fallback = WideVec3(0, 2, 0)},
             {.name = "at",
              .type = ParamType::point3,
              .doc = "Point that its front faces.",
              .unit = "m",
              .fallback = WideVec3(0)},
             {.name = "size",
              .type = ParamType::vector2,
              .doc = "What it measures.",
              .unit = "m",
              .fallback = Vec2(1.0, 1.0),
              .pair = "{width, height}"},
             color_spec("color", "Colour of the light."),
             strength_spec(10.0, "Radiance of its front.", "W/(m^2 sr)"),
             group_spec()},
            [](const Params& params) -> Light {
                AreaLight light;
                light.centre = params.point3("position");
                const Vec3 normal(params.point3("at") - light.centre);
                if (!(is_finite(normal) && normal.length() > 0))
                    throw params.error("at", "must differ from position");
                const Vec2& size = params.vector2("size");
                if (!(size.x > 0 && size.y > 0 && size.x < 1e6 && size.y < 1e6))
                    throw params.error("size", "must be above 0 and below 1000000 m");
                check_color(params, "color", params.color("color"), max_radiance);
                const Vec3 n = normal.normalized();
                const Vec3 up =
                    std::abs(n.y) < 0.999F ? Vec3(0.0F, 1.0F, 0.0F) : Vec3(0.0F, 0.0F, 1.0F);
                const Vec3 u = n.cross(up).normalized();
                light.edge_u = u * static_cast<float>(size.x);
                light.edge_v = n.cross(u) * static_cast<float>(size.y);
                light.radiance = params.color("color") * float_number(params, "strength");
                light.group = group_of(params);
                return light;
            }};
}

} // namespace

Registry<MakeLight> light_table() {
    Registry<MakeLight> table("light");
    table.add(sky_plugin());
    table.add(sun_plugin());
    table.add(area_plugin());
    return table;
}

} // namespace scree
