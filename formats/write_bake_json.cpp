// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/write_bake_json.h"

#include "core/version.h"

#include <nlohmann/json.hpp>

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
    if (const Strands* strands = prototype.strands())
        out["strands"] = strands->count();
    else
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
    out["instances"] = Json::array();
    for (const Instance& instance : aggregate.instances)
        out["instances"].push_back(instance_json(instance));
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
