// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/table.h"

namespace scree {

namespace {

ParamSpec paint_spec(const Color& fallback, std::string doc) {
    return {.name = "color",
            .type = ParamType::texture,
            .doc = std::move(doc),
            .fallback = Texture{fallback, nullptr}};
}

ParamSpec palette_spec() {
    return {.name = "palette",
            .type = ParamType::list,
            .doc = "Colours from which each instance picks one at random; in place of color.",
            .optional = true,
            .fields = {{.name = "color", .type = ParamType::color, .doc = "One of the colours."}},
            .min_items = 1};
}

ParamSpec roughness_spec(double fallback) {
    return {.name = "roughness",
            .type = ParamType::number,
            .doc = "Perceptual roughness; its square is the GGX alpha.",
            .fallback = fallback,
            .min = 0.0,
            .max = 1.0};
}

ParamSpec ior_spec() {
    return {.name = "ior",
            .type = ParamType::number,
            .doc = "Index of refraction relative to air.",
            .fallback = 1.5,
            .min = 1.01,
            .max = 3.0};
}

ParamSpec strength_spec(double fallback, std::string doc, std::string unit) {
    return {.name = "strength",
            .type = ParamType::number,
            .doc = std::move(doc),
            .unit = std::move(unit),
            .fallback = fallback,
            .min = 0.0,
            .max = 1e9};
}

ParamSpec color_spec(std::string name, std::string doc) {
    return {.name = std::move(name),
            .type = ParamType::color,
            .doc = std::move(doc),
            .fallback = Color(1.0F, 1.0F, 1.0F)};
}

void check_color(const Params& params, const std::string& name, const Color& color, float max) {
    for (int i = 0; i < 3; ++i)
        if (!(color[i] >= 0 && color[i] <= max))
            throw params.error(name, max == 1 ? "a reflectance must be from 0 to 1"
                                              : "light must not be negative");
}

constexpr float any_radiance = 1e9F;

Paint make_paint(const Params& params) {
    Paint paint{params.texture("color"), {}};
    if (paint.texture.procedural == nullptr)
        check_color(params, "color", paint.texture.constant, 1);
    if (params.has("palette"))
        for (const Params& entry : params.list("palette")) {
            check_color(entry, "color", entry.color("color"), 1);
            paint.palette.push_back(entry.color("color"));
        }
    return paint;
}

float number(const Params& params, const std::string& name) {
    return static_cast<float>(params.number(name));
}

Plugin<MakeMaterial> matte_plugin() {
    return {"matte",
            "A perfectly diffuse surface (Lambert 1760).",
            {paint_spec(Color(0.5F, 0.5F, 0.5F), "Diffuse reflectance."), palette_spec()},
            [](const Params& params) -> Material { return Matte{make_paint(params)}; }};
}

Plugin<MakeMaterial> plastic_plugin() {
    return {
        "plastic",
        "A diffuse base under a clear coat, for toys, varnish and polished stone.",
        {paint_spec(Color(0.5F, 0.5F, 0.5F), "Diffuse reflectance of the base."), palette_spec(),
         roughness_spec(0.3), ior_spec()},
        [](const Params& params) -> Material {
            return Plastic{make_paint(params), number(params, "roughness"), number(params, "ior")};
        }};
}

// Reflectance at normal incidence in linear Rec. 709: silver to iron from Lagarde, "Feeding a
// physically based shading model" (2011); brass from physicallybased.info (2022).
struct MetalPreset {
    const char* name;
    Color reflectance;
};
const MetalPreset metal_presets[] = {
    {"gold", {1.000F, 0.766F, 0.336F}},   {"copper", {0.955F, 0.637F, 0.538F}},
    {"silver", {0.972F, 0.960F, 0.915F}}, {"aluminium", {0.913F, 0.921F, 0.925F}},
    {"iron", {0.560F, 0.570F, 0.580F}},   {"brass", {0.910F, 0.778F, 0.423F}},
};

Plugin<MakeMaterial> metal_plugin() {
    std::vector<std::string> names;
    for (const MetalPreset& preset : metal_presets)
        names.emplace_back(preset.name);
    ParamSpec color =
        paint_spec({}, "Reflectance at normal incidence; in place of the preset when given.");
    color.fallback = {};
    color.optional = true;
    return {"metal",
            "A conductor with a GGX surface.",
            {{.name = "preset",
              .type = ParamType::choice,
              .doc = "A metal of known reflectance.",
              .fallback = std::string("aluminium"),
              .choices = names},
             color,
             palette_spec(),
             roughness_spec(0.2)},
            [](const Params& params) -> Material {
                Metal metal;
                metal.roughness = number(params, "roughness");
                for (const MetalPreset& preset : metal_presets)
                    if (params.text("preset") == preset.name)
                        metal.paint.texture = {preset.reflectance, nullptr};
                if (params.has("color"))
                    metal.paint = make_paint(params);
                else if (params.has("palette")) {
                    Params with_color = params;
                    with_color.set("color", metal.paint.texture);
                    metal.paint = make_paint(with_color);
                }
                return metal;
            }};
}

Plugin<MakeMaterial> glass_plugin() {
    return {"glass",
            "A dielectric that refracts; the inside of its closed mesh may be tinted.",
            {ior_spec(),
             color_spec("color", "Share of light left after `distance` inside; each above 0."),
             {.name = "distance",
              .type = ParamType::number,
              .doc = "Way through the glass that gives `color` (Beer's law).",
              .unit = "m",
              .fallback = 0.01,
              .min = 1e-6,
              .max = 1e3},
             roughness_spec(0.0)},
            [](const Params& params) -> Material {
                Glass glass;
                glass.ior = number(params, "ior");
                glass.roughness = number(params, "roughness");
                const Color& color = params.color("color");
                for (int i = 0; i < 3; ++i) {
                    if (!(color[i] > 0 && color[i] <= 1))
                        throw params.error("color", "each part must be above 0 and at most 1");
                    glass.absorption[i] = -std::log(color[i]) / number(params, "distance");
                }
                return glass;
            }};
}

Plugin<MakeLight> sky_plugin() {
    ParamSpec horizon = color_spec("horizon", "Radiance at the horizon; color when not given.");
    ParamSpec zenith = color_spec("zenith", "Radiance straight above; color when not given.");
    ParamSpec ground = color_spec("ground", "Radiance below the horizon; horizon when not given.");
    for (ParamSpec* spec : {&horizon, &zenith, &ground}) {
        spec->fallback = {};
        spec->optional = true;
    }
    return {"sky",
            "Light from all around: one colour, a vertical gradient, or an image.",
            {color_spec("color", "Radiance in every direction."),
             zenith,
             horizon,
             ground,
             {.name = "image",
              .type = ParamType::path,
              .doc = "A latitude-longitude image (EXR, PNG or JPEG), its top row straight above; "
                     "its centre is in direction -z; multiplied by color.",
              .optional = true},
             {.name = "rotation",
              .type = ParamType::number,
              .doc = "Turn about the y axis, counter-clockwise seen from above.",
              .unit = "deg",
              .fallback = 0.0,
              .min = -360.0,
              .max = 360.0},
             strength_spec(1.0, "Factor on all radiances.", "")},
            [](const Params& params) -> Light {
                Sky sky;
                const auto color = [&](const char* name, const Color& otherwise) {
                    if (!params.has(name))
                        return otherwise;
                    check_color(params, name, params.color(name), any_radiance);
                    return params.color(name);
                };
                const Color base = color("color", Color(1.0F, 1.0F, 1.0F));
                sky.zenith = color("zenith", base);
                sky.horizon = color("horizon", base);
                sky.ground = color("ground", sky.horizon);
                sky.rotation = number(params, "rotation");
                sky.strength = number(params, "strength");
                if (params.has("image")) {
                    for (const char* name : {"zenith", "horizon", "ground"})
                        if (params.has(name))
                            throw params.error(name, "cannot be given together with image");
                    try {
                        sky.image = std::make_shared<Image>(read_image(params.text("image")));
                    } catch (const Error& error) {
                        throw params.error("image", error.diagnostics().front().message);
                    }
                    for (const float value : sky.image->pixels)
                        if (!(value >= 0 && value < 1e30F))
                            throw params.error("image", "holds negative or infinite radiance");
                }
                return sky;
            }};
}

Plugin<MakeLight> sun_plugin() {
    return {"sun",
            "A distant disk of light.",
            {{.name = "direction",
              .type = ParamType::vector3,
              .doc = "Towards the sun; any length.",
              .fallback = Vec3(1.0F, 2.0F, 1.0F)},
             {.name = "angle",
              .type = ParamType::number,
              .doc = "Angular diameter; larger gives softer shadows.",
              .unit = "deg",
              .fallback = radians(0.53),
              .min = 0.01,
              .max = 90.0},
             color_spec("color", "Colour of the light."),
             strength_spec(3.0, "Irradiance on a surface that faces the sun.", "W/m^2")},
            [](const Params& params) -> Light {
                Sun sun{params.vector3("direction"), number(params, "angle"), params.color("color"),
                        number(params, "strength")};
                check_color(params, "color", sun.color, any_radiance);
                if (!(is_finite(sun.direction) && sun.direction.length() > 0))
                    throw params.error("direction", "must not be zero");
                sun.direction.normalize();
                return sun;
            }};
}

Plugin<MakeLight> area_plugin() {
    return {"area",
            "A rectangle that shines from its front; it is visible.",
            {{.name = "position",
              .type = ParamType::vector3,
              .doc = "Centre of the rectangle.",
              .unit = "m",
              .fallback = Vec3(0.0F, 2.0F, 0.0F)},
             {.name = "at",
              .type = ParamType::vector3,
              .doc = "Point that its front faces.",
              .unit = "m",
              .fallback = Vec3(0.0F, 0.0F, 0.0F)},
             {.name = "size",
              .type = ParamType::vector2,
              .doc = "Its width and height.",
              .unit = "m",
              .fallback = Vec2(1.0, 1.0)},
             color_spec("color", "Colour of the light."),
             strength_spec(10.0, "Radiance of the front.", "W/(m^2 sr)")},
            [](const Params& params) -> Light {
                AreaLight light;
                light.centre = params.vector3("position");
                const Vec3 normal = params.vector3("at") - light.centre;
                if (!(is_finite(normal) && normal.length() > 0))
                    throw params.error("at", "must differ from position");
                const Vec2& size = params.vector2("size");
                if (!(size.x > 0 && size.y > 0 && size.x < 1e6 && size.y < 1e6))
                    throw params.error("size", "must be above 0 and below 1000000 m");
                check_color(params, "color", params.color("color"), any_radiance);
                const Vec3 n = normal.normalized();
                const Vec3 up =
                    std::abs(n.y) < 0.999F ? Vec3(0.0F, 1.0F, 0.0F) : Vec3(0.0F, 0.0F, 1.0F);
                const Vec3 u = n.cross(up).normalized();
                light.edge_u = u * static_cast<float>(size.x);
                light.edge_v = n.cross(u) * static_cast<float>(size.y);
                light.radiance = params.color("color") * number(params, "strength");
                return light;
            }};
}

Plugin<MakeCamera> perspective_plugin() {
    return {"perspective",
            "A pinhole or thin-lens camera.",
            {{.name = "from", .type = ParamType::vector3, .doc = "Where the eye is.", .unit = "m"},
             {.name = "at",
              .type = ParamType::vector3,
              .doc = "What it looks at.",
              .unit = "m",
              .fallback = Vec3(0.0F, 0.0F, 0.0F)},
             {.name = "up",
              .type = ParamType::vector3,
              .doc = "Upwards in the picture.",
              .fallback = Vec3(0.0F, 1.0F, 0.0F)},
             {.name = "fov",
              .type = ParamType::number,
              .doc = "Full vertical angle of view.",
              .unit = "deg",
              .fallback = radians(35),
              .min = 0.1,
              .max = 170.0},
             {.name = "aperture",
              .type = ParamType::number,
              .doc = "Diameter of the lens; 0 keeps everything in focus.",
              .unit = "m",
              .fallback = 0.0,
              .min = 0.0,
              .max = 10.0},
             {.name = "focus",
              .type = ParamType::number,
              .doc = "Distance of the plane in focus; that of `at` when not given.",
              .unit = "m",
              .optional = true,
              .min = 1e-4,
              .max = 1e6}},
            [](const Params& params) -> Camera {
                Camera camera;
                camera.from = params.vector3("from");
                camera.at = params.vector3("at");
                camera.up = params.vector3("up");
                camera.fov = number(params, "fov");
                camera.aperture = number(params, "aperture");
                camera.focus = params.has("focus") ? number(params, "focus") : 0.0F;
                const Vec3 view = camera.at - camera.from;
                if (!(is_finite(view) && view.length() > 0))
                    throw params.error("at", "must differ from `from`");
                if (!(view.normalized().cross(camera.up.normalized()).length() > 1e-6F))
                    throw params.error("up", "must not be parallel to the view direction");
                return camera;
            }};
}

struct FilterName {
    const char* name;
    Filter filter;
    float radius; // customary [pixels]
};
// Radii: box and triangle by definition; the others as PBRT-v4 and Cycles (width 1.5 px) use them.
const FilterName filter_names[] = {{"blackman_harris", Filter::blackman_harris, 1.5F},
                                   {"gaussian", Filter::gaussian, 1.5F},
                                   {"triangle", Filter::triangle, 1.0F},
                                   {"box", Filter::box, 0.5F}};

ParamSpec count_spec(std::string name, std::string doc, std::string unit, std::int64_t fallback,
                     double max) {
    return {.name = std::move(name),
            .type = ParamType::integer,
            .doc = std::move(doc),
            .unit = std::move(unit),
            .fallback = fallback,
            .min = 1.0,
            .max = max};
}

Plugin<MakeFilm> film_plugin() {
    std::vector<std::string> names;
    for (const FilterName& row : filter_names)
        names.emplace_back(row.name);
    return {"film",
            "The picture: its size and how it is sampled.",
            {count_spec("width", "Width of the picture.", "pixels", 1280, 16384),
             count_spec("height", "Height of the picture.", "pixels", 720, 16384),
             count_spec("samples", "Paths per pixel.", "", 64, 1 << 20),
             count_spec("depth", "Longest path; 1 shows light sources only, 2 direct light.", "",
                        16, 1000),
             {.name = "filter",
              .type = ParamType::choice,
              .doc = "Reconstruction filter.",
              .fallback = std::string("blackman_harris"),
              .choices = names},
             {.name = "radius",
              .type = ParamType::number,
              .doc = "Radius of the filter; what is customary for it when not given.",
              .unit = "pixels",
              .optional = true,
              .min = 0.1,
              .max = 8.0},
             {.name = "clamp",
              .type = ParamType::number,
              .doc = "Largest value of one indirect contribution; removes fireflies at the price "
                     "of some energy.",
              .optional = true,
              .min = 0.0,
              .max = 1e9,
              .above_min = true},
             {.name = "exposure",
              .type = ParamType::number,
              .doc = "Exposure of the view.",
              .unit = "stops",
              .fallback = 0.0,
              .min = -20.0,
              .max = 20.0}},
            [](const Params& params) -> FilmSettings {
                FilmSettings film;
                film.width = static_cast<int>(params.integer("width"));
                film.height = static_cast<int>(params.integer("height"));
                film.samples = static_cast<int>(params.integer("samples"));
                film.depth = static_cast<int>(params.integer("depth"));
                for (const FilterName& row : filter_names)
                    if (params.text("filter") == row.name) {
                        film.filter = row.filter;
                        film.radius = row.radius;
                    }
                if (params.has("radius"))
                    film.radius = number(params, "radius");
                if (params.has("clamp"))
                    film.clamp = number(params, "clamp");
                film.exposure = number(params, "exposure");
                return film;
            }};
}

} // namespace

Registry<MakeMaterial> material_table() {
    Registry<MakeMaterial> table("material");
    table.add(matte_plugin());
    table.add(plastic_plugin());
    table.add(metal_plugin());
    table.add(glass_plugin());
    return table;
}

Registry<MakeLight> light_table() {
    Registry<MakeLight> table("light");
    table.add(sky_plugin());
    table.add(sun_plugin());
    table.add(area_plugin());
    return table;
}

Registry<MakeCamera> camera_table() {
    Registry<MakeCamera> table("camera");
    table.add(perspective_plugin());
    return table;
}

Registry<MakeFilm> film_table() {
    Registry<MakeFilm> table("film");
    table.add(film_plugin());
    return table;
}

} // namespace scree
