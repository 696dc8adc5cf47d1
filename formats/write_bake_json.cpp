// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/write_bake_json.h"

#include "core/version.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>

namespace scree {

namespace {

using Json = nlohmann::ordered_json;

bool is_time(const std::string& fact) { return fact == "seconds" || fact.ends_with("_seconds"); }

Json number_json(double value) {
    if (is_whole(value))
        return static_cast<std::int64_t>(value);
    return value;
}

Json rings_json(const Region& region) {
    Json rings = Json::array();
    for (const Ring& ring : region.rings) {
        Json points = Json::array();
        for (const Vec2& p : ring)
            points.push_back({p.x, p.y});
        rings.push_back(std::move(points));
    }
    return rings;
}

// Three rows of four for column vectors, the usual convention: the transpose of Imath's matrix.
Json matrix_json(const WideMatrix& m) {
    Json numbers = Json::array();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            numbers.push_back(m[column][row]);
    return numbers;
}

Json prototype_json(const Prototype& prototype) {
    Json out{{"name", prototype.name}};
    if (const Strands* strands = prototype.strands()) {
        out["strands"] = strands->count();
        out["curve"] = strands->kind == CurveKind::linear ? "linear" : "bspline";
    } else
        out["triangles"] = prototype.mesh() != nullptr ? prototype.mesh()->triangles.size() : 0;
    if (prototype.region)
        out["region"] = rings_json(*prototype.region);
    if (prototype.outline)
        out["outline"] = rings_json(*prototype.outline);
    return out;
}

Json instance_json(const Instance& instance) {
    const WideMatrix& m = instance.world_from_object;
    return {{"prototype", instance.prototype},
            {"position", {m[3][0], m[3][1], m[3][2]}},
            {"angle", degrees(instance.angle)},
            {"scale", instance.scale},
            {"matrix", matrix_json(m)}};
}

// The shortest decimal that is read back as the same float.
double shortest(float value) {
    const std::string text = fmt::format("{}", value);
    double out = 0;
    std::from_chars(text.data(), text.data() + text.size(), out);
    return out;
}

// The strands of an instance, in the world.
void add_strands(Json& list, const Instance& instance, const Strands& strands) {
    const WideMatrix& m = instance.world_from_object;
    const double volume =
        WideVec3(m[0][0], m[0][1], m[0][2])
            .dot(WideVec3(m[1][0], m[1][1], m[1][2]).cross(WideVec3(m[2][0], m[2][1], m[2][2])));
    const auto scale = static_cast<float>(std::cbrt(std::abs(volume)));
    for (std::size_t strand = 0; strand < strands.count(); ++strand) {
        Json points = Json::array();
        Json radius = Json::array();
        for (std::size_t i = strands.offsets[strand]; i < strands.offsets[strand + 1]; ++i) {
            const Vec3 p = transform_point(m, strands.points[i]);
            points.push_back({shortest(p.x), shortest(p.y), shortest(p.z)});
            radius.push_back(shortest(strands.radii[i] * scale));
        }
        list.push_back({{"prototype", instance.prototype},
                        {"points", std::move(points)},
                        {"radius", std::move(radius)}});
    }
}

// Strands are written one by one, everything else as instances.
void add_instances(Json& out, const Aggregate& aggregate) {
    out["instances"] = Json::array();
    Json strands = Json::array();
    for (const Instance& instance : aggregate.instances) {
        const Prototype& prototype = aggregate.prototypes[instance.prototype];
        if (prototype.strands() != nullptr)
            add_strands(strands, instance, *prototype.strands());
        else
            out["instances"].push_back(instance_json(instance));
    }
    if (strands.empty())
        return;
    if (out["instances"].empty())
        out.erase("instances");
    out["strands"] = std::move(strands);
}

Json aggregate_json(const Aggregate& aggregate) {
    // Times are left out, since equal scenes must give equal files; `--stats` shows them.
    Json facts = Json::object();
    for (const auto& [name, value] : aggregate.facts)
        if (!is_time(name))
            facts[name] = number_json(value);
    Json out{{"generator", aggregate.generator}};
    if (!aggregate.name.empty())
        out["name"] = aggregate.name;
    out["seed"] = aggregate.seed;
    out["facts"] = facts;
    if (aggregate.domain)
        out["domain"] = {{"rings", rings_json(*aggregate.domain)}, {"torus", aggregate.torus}};
    out["prototypes"] = Json::array();
    for (const Prototype& prototype : aggregate.prototypes)
        out["prototypes"].push_back(prototype_json(prototype));
    add_instances(out, aggregate);
    return out;
}

} // namespace

std::string bake_json(std::span<const Aggregate> aggregates, const BakeSource& source) {
    Json root{{"scree", SCREE_VERSION}, {"scene", source.scene}, {"seed", source.seed}};
    root["aggregates"] = Json::array();
    for (const Aggregate& aggregate : aggregates)
        root["aggregates"].push_back(aggregate_json(aggregate));
    return root.dump(1) + "\n";
}

} // namespace scree
