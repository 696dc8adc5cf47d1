// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_stats.h"

#include "core/parallel.h"
#include "core/version.h"
#include "formats/bake_json.h"
#include "render/render.h"

#include <nlohmann/json.hpp>

namespace scree {

std::string run_stats_json(const Stages& stages, std::span<const Aggregate> aggregates,
                           const RenderFigures* render) {
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
        Json facts = Json::object();
        for (const auto& [name, value] : aggregate.facts) {
            if (is_whole(value))
                facts[name] = static_cast<std::int64_t>(value);
            else
                facts[name] = value;
        }
        root["generators"].push_back({{"generator", aggregate.generator}, {"facts", facts}});
    }
    if (render != nullptr) {
        const RenderStats& stats = *render->stats;
        root["render"] = {{"samples_per_pixel", stats.samples_per_pixel},
                          {"rays", stats.rays},
                          {"mrays_per_s", stats.mrays_per_s()},
                          {"embree_share", stats.embree_share},
                          {"instances", render->instances},
                          {"scene_mib", double(render->scene_bytes) / (1 << 20)},
                          {"invalid_samples", stats.invalid_samples}};
    }
    return root.dump(2) + "\n";
}

} // namespace scree
