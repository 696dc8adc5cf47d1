// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/rocks_settings.h"

#include "generators/rocks/rocks_specs.h"
#include "geometry/rock/rock_params.h"
#include "model/file_material.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree::rocks {

namespace {

constexpr double steepest_heap = 36; // [deg]

double number_or(const Params& params, const std::string& name, double otherwise) {
    return params.has(name) ? params.number(name) : otherwise;
}

/// A parameter that only one method knows.
struct OwnParameter {
    const char* name;
    Method method;
};
constexpr OwnParameter own_parameters[] = {
    {"preset", Method::dropped},     {"cover", Method::dropped},
    {"slope", Method::dropped},      {"ground", Method::dropped},
    {"dip", Method::dropped},        {"flow", Method::dropped},
    {"sorting", Method::dropped},    {"density", Method::dropped},
    {"size", Method::dropped},       {"ground_material", Method::dropped},
    {"prototypes", Method::dropped}, {"unique", Method::dropped},
    {"measure", Method::dropped},    {"smallest", Method::dropped},
    {"largest", Method::dropped},    {"exponent", Method::dropped},
    {"joint", Method::mosaic},       {"exclusion", Method::paper}};

const char* name_of(Method method) {
    return method == Method::paper ? "paper" : method == Method::mosaic ? "mosaic" : "dropped";
}

/// A parameter that has no effect is an error.
void check_method(const Params& params, Method method) {
    for (const OwnParameter& own : own_parameters)
        if (own.method != method && params.has(own.name))
            throw params.error(own.name,
                               fmt::format("is unknown to the method {}", name_of(method)),
                               fmt::format("it is for the method {}", name_of(own.method)));
}

void check_distribution(const Params& params, Distribution distribution) {
    const auto refuse = [&](const char* name, const char* known_to) {
        if (params.has(name))
            throw params.error(
                name,
                fmt::format("is given beside the distribution {}",
                            params.has("distribution") ? params.text("distribution") : "classes"),
                fmt::format("it is for {}", known_to));
    };
    if (distribution == Distribution::classes) {
        refuse("smallest", "power and area");
        refuse("largest", "power and area");
    } else {
        refuse("sizes", "classes");
    }
    if (distribution != Distribution::power)
        refuse("exponent", "power");
}

Distribution distribution_of(const Params& params, Method method) {
    const std::string preset = params.has("preset") ? params.text("preset") : "";
    const std::string name = params.has("distribution") ? params.text("distribution")
                             : params.has("sizes")      ? "classes"
                             : preset == "desert"       ? "area"
                                                        : "power";
    if (method != Method::dropped && name != "classes")
        throw params.error(params.has("distribution") ? "distribution" : "method",
                           fmt::format("the method {} knows classes only", params.text("method")),
                           "expected sizes");
    return name == "classes" ? Distribution::classes
           : name == "power" ? Distribution::power
                             : Distribution::area;
}

void read_classes(const Params& params, RocksSettings& settings) {
    if (!params.has("sizes"))
        throw params.error("sizes", "is missing", "expected a list of { radius = , share = }");
    double shares = 0;
    for (const Params& given : params.list("sizes")) {
        settings.classes.push_back({given.number("radius"), given.number("share")});
        settings.swellings.push_back(
            {WideVec3(given.vector3("widening")), WideVec3(given.vector3("height"))});
        shares += given.number("share");
        const Vec2 extent = bounds(*settings.domain).size();
        if (given.number("radius") > std::min(extent.x, extent.y))
            throw given.error("radius", "is larger than the domain");
        if (given.number("share") * area(*settings.domain) <
            0.5 * cell_area(settings.classes.back()))
            throw given.error("share", "is less than half a cell of this radius");
    }
    if (shares > 1 + 1e-9)
        throw params.error("sizes", fmt::format("the shares add up to {:g}", shares),
                           "expected at most 1");
}

void read_sizes(const Params& params, RocksSettings& settings) {
    settings.distribution = distribution_of(params, settings.method);
    check_distribution(params, settings.distribution);
    settings.exponent = number_or(params, "exponent", settings.exponent);
    settings.cover = number_or(params, "cover", settings.cover);
    if (settings.distribution == Distribution::classes) {
        read_classes(params, settings);
        return;
    }
    for (const char* name : {"smallest", "largest"})
        if (!params.has(name))
            throw params.error(name, "is missing",
                               "expected the length of a longest axis in m, or sizes");
    settings.smallest = params.number("smallest");
    settings.largest = params.number("largest");
    if (settings.smallest >= settings.largest)
        throw params.error("largest", "is not larger than the smallest");
    const Vec2 extent = bounds(*settings.domain).size();
    if (settings.largest > std::max(extent.x, extent.y))
        throw params.error("largest", "is longer than the domain");
    if (settings.distribution == Distribution::area && settings.cover > 1)
        throw params.error("cover", "is over 1 for the distribution area", "expected at most 1");
}

void read_ground(const Params& params, const Preset& preset, RocksSettings& settings) {
    settings.ground = params.object<Mesh>("ground");
    settings.ground_place = params.place("ground");
    if (settings.ground && params.has("slope"))
        throw params.error("slope", "is given beside a ground; one of them will do");
    settings.slope = settings.ground ? 0 : number_or(params, "slope", radians(preset.slope));
    if (settings.slope > radians(steepest_heap))
        params.warn("slope",
                    fmt::format("rocks do not rest on more than {} degrees", steepest_heap));
    settings.burial = number_or(params, "burial", preset.burial);
    settings.dip = number_or(params, "dip", radians(preset.dip));
    settings.flow = number_or(params, "flow", 0);
    settings.sorting = number_or(params, "sorting", preset.sorting);
    settings.density = field_of(params, "density");
    if (settings.density && settings.density->over(bounds(*settings.domain)).high <= 0)
        params.warn("density", "is 0 in all of the domain: there will be no rocks");
    settings.size = field_of(params, "size");
}

void read_materials(const Params& params, RocksSettings& settings) {
    settings.materials = materials_of(params, nullptr);
    if (params.has("materials")) {
        if (!settings.materials.empty())
            throw params.error("materials", "is given beside a material; one of them will do");
        for (const Params& given : params.list("materials"))
            settings.materials.push_back(given.object<Material>("material"));
    }
    settings.ground_material = params.object<Material>("ground_material");
}

} // namespace

RocksSettings rocks_settings(const Params& params) {
    const Preset& preset = preset_of(params);
    RocksSettings settings;
    const std::string& method = params.text("method");
    settings.method = method == "paper"    ? Method::paper
                      : method == "mosaic" ? Method::mosaic
                                           : Method::dropped;
    check_method(params, settings.method);
    settings.domain = params.object<Region>("domain");
    settings.domain_place = params.place("domain");
    read_sizes(params, settings);
    settings.rock = rock_settings(params);
    settings.rock.wear = number_or(params, "wear", preset.wear);
    settings.spread = params.number("spread");
    settings.wear_spread = number_or(params, "wear_spread", preset.wear_spread);
    settings.joint = number_or(params, "joint", settings.joint);
    read_ground(params, preset, settings);
    settings.level = params.has("triangles") ? rock_level(double(params.integer("triangles"))) : 0;
    if (params.has("prototypes"))
        settings.prototypes = static_cast<int>(params.integer("prototypes"));
    settings.unique = params.has("unique") && params.flag("unique");
    settings.half_exclusion = !params.has("exclusion") || params.text("exclusion") == "half";
    if (params.has("measure"))
        settings.measure = static_cast<std::size_t>(params.integer("measure"));
    read_materials(params, settings);
    settings.seed = static_cast<std::uint64_t>(params.integer("seed"));
    return settings;
}

} // namespace scree::rocks
