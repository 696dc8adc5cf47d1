// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/run_stats.h"

#include "core/parallel.h"
#include "core/version.h"
#include "fabrication/fabricate.h"
#include "formats/write_bake_json.h"

#include <nlohmann/json.hpp>

namespace scree {

namespace {

nlohmann::ordered_json facts_json(const Facts& facts) {
    nlohmann::ordered_json out = nlohmann::ordered_json::object();
    for (const auto& [name, value] : facts) {
        if (is_whole(value))
            out[name] = static_cast<std::int64_t>(value);
        else
            out[name] = value;
    }
    return out;
}

nlohmann::ordered_json parts_json(std::span<const FabricationPart> parts) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const FabricationPart& part : parts)
        out.push_back({{"volume_mm3", part.volume * 1e9}, {"triangles", part.triangles}});
    return out;
}

nlohmann::ordered_json solid_json(const Fabrication& solid) {
    return {{"components", solid.solids},
            {"resolution_mm", solid.resolution * 1000},
            {"triangles", solid.mesh.triangles.size()},
            {"parts", parts_json(solid.parts)},
            {"removed", parts_json(solid.removed)},
            {solid.voids_kept ? "voids_kept" : "voids_filled", solid.voids},
            {"void_volume_mm3", solid.void_volume * 1e9}};
}

} // namespace

std::string run_stats_json(const Stages& stages, std::span<const Aggregate> aggregates,
                           const RenderFigures* render, const Facts& texture,
                           const Fabrication* solid) {
    using Json = nlohmann::ordered_json;
    Json root{{"scree", SCREE_VERSION}, {"threads", thread_count()}};
    root["stages"] = Json::array();
    for (const StageCost& cost : stages.costs())
        root["stages"].push_back({{"name", cost.name},
                                  {"wall_s", cost.wall_s},
                                  {"cpu_s", cost.cpu_s},
                                  {"peak_mib", cost.peak_mib}});
    root["generators"] = Json::array();
    for (const Aggregate& aggregate : aggregates) {
        if (aggregate.generator == "object")
            continue;
        Json generator{{"generator", aggregate.generator}};
        if (!aggregate.name.empty())
            generator["name"] = aggregate.name;
        generator["facts"] = facts_json(aggregate.facts);
        root["generators"].push_back(std::move(generator));
    }
    if (render != nullptr) {
        const RenderStats& stats = render->stats;
        root["render"] = {{"samples_per_pixel", stats.samples_per_pixel},
                          {"relative_error", stats.error},
                          {"rays", stats.rays},
                          {"mrays_per_s", stats.mrays_per_s()},
                          {"embree_share", stats.embree_share},
                          {"instances", render->instances},
                          {"scene_mib", double(render->scene_bytes) / (1 << 20)},
                          {"invalid_samples", stats.invalid_samples}};
        if (render->strands.strands > 0)
            root["render"]["strands"] = {{"count", render->strands.strands},
                                         {"segments", render->strands.segments},
                                         {"mib", double(render->strands.bytes) / (1 << 20)}};
    }
    if (!texture.empty())
        root["texture"] = facts_json(texture);
    if (solid != nullptr)
        root["solid"] = solid_json(*solid);
    return root.dump(2) + "\n";
}

} // namespace scree
