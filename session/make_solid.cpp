// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/make_solid.h"

#include "core/error.h"
#include "core/text.h"

#include <fmt/format.h>

#include <numeric>

namespace scree {

namespace {

std::string volume_text(double cubic_metres) {
    return fmt::format("{:.4g} mm3", cubic_metres * 1e9);
}

std::string describe(const Fabrication& made) {
    std::string out =
        fmt::format("solid: {} united at {:.4g} mm, {}, {}, {}", counted(made.solids, "component"),
                    made.resolution * 1000, counted(made.parts.size(), "part"),
                    counted(made.mesh.triangles.size(), "triangle"),
                    volume_text(std::accumulate(made.parts.begin(), made.parts.end(), 0.0,
                                                [](double sum, const FabricationPart& part) {
                                                    return sum + part.volume;
                                                })));
    if (made.voids > 0)
        out += fmt::format(", {} of {} {}", counted(made.voids, "enclosed void"),
                           volume_text(made.void_volume), made.voids_kept ? "kept" : "filled");
    return out;
}

// Names the first few and counts the others.
void say_removed(const Fabrication& made, Watcher& watcher) {
    constexpr std::size_t shown = 5;
    if (made.removed.empty())
        return;
    std::string list;
    double rest = 0;
    for (std::size_t i = 0; i < made.removed.size(); ++i) {
        if (i < shown)
            list += (i > 0 ? ", " : "") + volume_text(made.removed[i].volume);
        else
            rest += made.removed[i].volume;
    }
    if (made.removed.size() > shown)
        list += fmt::format(" and {} more of {} together", made.removed.size() - shown,
                            volume_text(rest));
    watcher.say(fmt::format("removed {} not connected with the largest: {}; --parts keep keeps "
                            "them, --bridge joins what is near",
                            counted(made.removed.size(), "part"), list));
}

std::string problem_of(const OpenComponent& component) {
    if (component.has_strands)
        return fmt::format("{} is of strands, which solids are not made of yet", component.name);
    if (!component.has_mesh)
        return fmt::format("{} is a picture and has no solid", component.name);
    if (component.facts.boundary_edges > 0)
        return fmt::format("{} is not closed: it has {}", component.name,
                           counted(component.facts.boundary_edges, "boundary edge"));
    return fmt::format("{} is not the surface of a solid: at {} three or more triangles meet, or "
                       "two that do not agree which side is out",
                       component.name, counted(component.facts.non_manifold_edges, "edge"));
}

void check_closed(std::span<const Aggregate> aggregates, bool skip, Watcher& watcher) {
    std::vector<Diagnostic> problems;
    for (const OpenComponent& component : open_components(aggregates)) {
        const Aggregate& aggregate = aggregates[component.aggregate];
        const std::string path = "generator." + title(aggregate);
        if (skip)
            watcher.say(fmt::format("left out {} of {}: {}",
                                    counted(component.instances, "instance"), path,
                                    problem_of(component)));
        else
            problems.push_back({aggregate.where, path, problem_of(component),
                                "close it in a modelling program, or leave it out with --open "
                                "skip"});
    }
    if (!problems.empty())
        throw Error(Fault::input, problems);
}

} // namespace

Fabrication make_solid(std::span<const Aggregate> aggregates, const SolidOptions& options,
                       Session& session) {
    Watcher& watcher = session.watcher();
    check_closed(aggregates, options.skip_open, watcher);
    session.stages().begin("solid");
    Fabrication made = fabricate(aggregates, options.fabrication, session.context("solid"));
    session.stages().end();
    watcher.say(describe(made));
    say_removed(made, watcher);
    return made;
}

} // namespace scree
