// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/read_bake_json.h"

#include "core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

using Json = nlohmann::json;

constexpr double max_coordinate = 1e9; // [m]; larger ones lose all precision in squared areas

/// A JSON value with its path for error messages: "aggregates[0].instances[3].matrix".
struct Located {
    const Json& json;
    const std::string& file;
    std::string path;

    Error error(const std::string& message) const {
        return Error(Diagnostic{{file, 0}, path, message, ""});
    }
    const Located& expect(bool right, const char* what) const {
        if (!right)
            throw error(fmt::format("expected {}, got {}", what, shown()));
        return *this;
    }
    std::string shown() const {
        const std::string text = json.is_array() || json.is_object()
                                     ? fmt::format("{} of {}", json.type_name(), json.size())
                                     : json.dump(-1, ' ', false, Json::error_handler_t::replace);
        return text.size() > 40 ? text.substr(0, 37) + "..." : text;
    }
    bool has(const char* key) const { return json.contains(key); }
    Located at(const char* key) const {
        expect(json.is_object(), "an object");
        const std::string inner = path.empty() ? key : path + "." + key;
        if (!has(key))
            throw Error(Diagnostic{{file, 0}, inner, "is missing", ""});
        return {json.at(key), file, inner};
    }
    Located at(std::size_t i) const { return {json.at(i), file, fmt::format("{}[{}]", path, i)}; }
    std::size_t list_size() const { return expect(json.is_array(), "a list").json.size(); }

    double number() const {
        expect(json.is_number(), "a number");
        const double value = json.get<double>();
        expect(std::isfinite(value) && std::abs(value) <= max_coordinate,
               "a number between -1e9 and 1e9");
        return value;
    }
    std::uint64_t whole(std::uint64_t below, const char* what) const {
        expect(json.is_number_unsigned() && json.get<std::uint64_t>() < below, what);
        return json.get<std::uint64_t>();
    }
    std::string text() const { return expect(json.is_string(), "a text").json.get<std::string>(); }
};

std::shared_ptr<const Region> read_region(const Located& rings) {
    auto region = std::make_shared<Region>();
    for (std::size_t r = 0; r < rings.list_size(); ++r) {
        const Located ring = rings.at(r);
        ring.expect(ring.list_size() >= 3, "a ring of at least 3 points");
        Ring& out = region->rings.emplace_back();
        for (std::size_t i = 0; i < ring.json.size(); ++i) {
            const Located point = ring.at(i);
            point.expect(point.json.is_array() && point.json.size() == 2, "a point [x, z]");
            out.emplace_back(point.at(std::size_t{0}).number(), point.at(std::size_t{1}).number());
        }
    }
    if (!(area(*region) > 0))
        throw rings.error("has no area; outer rings turn counter-clockwise, holes clockwise");
    return region;
}

bool is_box(const Region& region) {
    if (region.rings.size() != 1 || region.rings[0].size() != 4)
        return false;
    const Vec2 size = bounds(region).size();
    return std::abs(area(region) - size.x * size.y) <= 1e-9 * size.x * size.y;
}

Instance read_instance(const Located& in, std::size_t prototypes) {
    Instance instance;
    const Located prototype = in.at("prototype");
    instance.prototype = static_cast<std::uint32_t>(prototype.whole(
        prototypes, fmt::format("the index of one of {} prototypes", prototypes).c_str()));
    const Located matrix = in.at("matrix");
    matrix.expect(matrix.json.is_array() && matrix.json.size() == 12, "12 numbers");
    for (std::size_t i = 0; i < 12; ++i)
        instance.world_from_object[static_cast<int>(i % 4)][static_cast<int>(i / 4)] =
            matrix.at(i).number();
    if (in.has("angle"))
        instance.angle = radians(in.at("angle").number());
    if (in.has("scale"))
        instance.scale = in.at("scale").number();
    return instance;
}

void read_strand(const Located& in, Strands& strands) {
    const Located points = in.at("points");
    const Located radius = in.at("radius");
    const std::size_t least = strands.piece_points();
    points.expect(points.list_size() >= least,
                  fmt::format("a list of at least {} points", least).c_str());
    radius.expect(radius.list_size() == points.json.size(), "one number for each point");
    for (std::size_t i = 0; i < points.json.size(); ++i) {
        const Located point = points.at(i);
        point.expect(point.json.is_array() && point.json.size() == 3, "a point [x, y, z]");
        Vec3& p = strands.points.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis)
            p[static_cast<int>(axis)] = static_cast<float>(point.at(axis).number());
        const Located r = radius.at(i);
        r.expect(r.number() >= 0, "a number that is not below 0");
        strands.radii.push_back(static_cast<float>(r.number()));
    }
    strands.offsets.push_back(static_cast<std::uint32_t>(strands.points.size()));
}

CurveKind curve_of(const Located& prototype) {
    if (!prototype.has("curve"))
        return CurveKind::linear;
    const Located curve = prototype.at("curve");
    const std::string kind = curve.text();
    curve.expect(kind == "linear" || kind == "bspline", "\"linear\" or \"bspline\"");
    return kind == "linear" ? CurveKind::linear : CurveKind::bspline;
}

void read_strands(const Located& list, const Located& prototypes, Aggregate& aggregate) {
    std::vector<std::shared_ptr<Strands>> of_prototype(aggregate.prototypes.size());
    for (std::size_t i = 0; i < list.list_size(); ++i) {
        const Located strand = list.at(i);
        const std::size_t number =
            strand.has("prototype")
                ? strand.at("prototype").whole(of_prototype.size(), "the index of a prototype")
                : 0;
        strand.expect(number < of_prototype.size(), "a strand of one of the prototypes");
        std::shared_ptr<Strands>& strands = of_prototype[number];
        if (strands == nullptr) {
            strands = std::make_shared<Strands>();
            strands->name = aggregate.prototypes[number].name;
            strands->kind = curve_of(prototypes.at(number));
            strands->offsets.push_back(0);
        }
        read_strand(strand, *strands);
    }
    for (std::uint32_t i = 0; i < of_prototype.size(); ++i)
        if (of_prototype[i] != nullptr) {
            aggregate.prototypes[i].shape = std::shared_ptr<const Strands>(of_prototype[i]);
            aggregate.instances.push_back({.prototype = i, .world_from_object = {}});
        }
}

Aggregate read_aggregate(const Located& in) {
    Aggregate aggregate;
    aggregate.generator = in.at("generator").text();
    if (in.has("name"))
        aggregate.name = in.at("name").text();
    if (in.has("seed"))
        aggregate.seed =
            in.at("seed").whole(std::numeric_limits<std::uint64_t>::max(), "a whole number");
    if (in.has("domain")) {
        const Located domain = in.at("domain");
        aggregate.domain = read_region(domain.at("rings"));
        if (domain.has("torus")) {
            const Located torus = domain.at("torus");
            aggregate.torus = torus.expect(torus.json.is_boolean(), "true or false").json;
            if (aggregate.torus && !is_box(*aggregate.domain))
                throw torus.error("a torus needs a rectangle along the axes for its domain");
        }
    }
    const Located prototypes = in.at("prototypes");
    for (std::size_t i = 0; i < prototypes.list_size(); ++i) {
        const Located prototype = prototypes.at(i);
        Prototype& out = aggregate.prototypes.emplace_back();
        out.name = prototype.at("name").text();
        if (prototype.has("region"))
            out.region = read_region(prototype.at("region"));
        if (prototype.has("outline"))
            out.outline = read_region(prototype.at("outline"));
    }
    if (in.has("strands"))
        read_strands(in.at("strands"), prototypes, aggregate);
    if (in.has("strands") && !in.has("instances"))
        return aggregate;
    const Located instances = in.at("instances");
    for (std::size_t i = 0; i < instances.list_size(); ++i)
        aggregate.instances.push_back(read_instance(instances.at(i), aggregate.prototypes.size()));
    return aggregate;
}

} // namespace

bool is_bake_json(std::string_view text) {
    return text.find("\"aggregates\"") != std::string_view::npos;
}

std::vector<Aggregate> read_bake_json(const std::string& text, const std::string& path) {
    Json root;
    try {
        root = Json::parse(text);
    } catch (const Json::exception& failure) {
        // The library's message differs between versions; only the position is reported.
        const auto* problem = dynamic_cast<const Json::parse_error*>(&failure);
        const std::size_t byte = problem != nullptr ? problem->byte : 0;
        const auto end = text.begin() + std::ptrdiff_t(std::min(byte, text.size()));
        throw Error(Diagnostic{{path, 1 + static_cast<int>(std::count(text.begin(), end, '\n'))},
                               "",
                               "is not JSON",
                               ""});
    }
    const Located aggregates = Located{root, path, ""}.at("aggregates");
    std::vector<Aggregate> out;
    for (std::size_t i = 0; i < aggregates.list_size(); ++i)
        out.push_back(read_aggregate(aggregates.at(i)));
    return out;
}

} // namespace scree
