// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/solid_options.h"

#include "core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <numeric>

namespace scree {

namespace {

std::string plural(std::size_t count, const std::string& word) {
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

std::string volume_text(double cubic_metres) {
    return fmt::format("{:.4g} mm3", cubic_metres * 1e9);
}

std::string describe(const Fabrication& made) {
    std::string out =
        fmt::format("solid: {} united at {:.4g} mm, {}, {}, {}", plural(made.solids, "component"),
                    made.resolution * 1000, plural(made.parts.size(), "part"),
                    plural(made.mesh.triangles.size(), "triangle"),
                    volume_text(std::accumulate(made.parts.begin(), made.parts.end(), 0.0,
                                                [](double sum, const FabricationPart& part) {
                                                    return sum + part.volume;
                                                })));
    if (made.voids > 0)
        out += fmt::format(", {} of {} {}", plural(made.voids, "enclosed void"),
                           volume_text(made.void_volume), made.voids_kept ? "kept" : "filled");
    return out;
}

// The first few by name, the others by number.
void say_removed(const Fabrication& made, Console& console) {
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
    console.say(fmt::format("removed {} not connected with the largest: {}; --parts keep keeps "
                            "them, --bridge joins what is near",
                            plural(made.removed.size(), "part"), list));
}

std::string problem_of(const OpenComponent& component) {
    if (!component.has_mesh)
        return fmt::format("{} is a picture and has no solid", component.name);
    if (component.facts.boundary_edges > 0)
        return fmt::format("{} is not closed: it has {}", component.name,
                           plural(component.facts.boundary_edges, "boundary edge"));
    return fmt::format("{} is not the surface of a solid: at {} three or more triangles meet, or "
                       "two that do not agree which side is out",
                       component.name, plural(component.facts.non_manifold_edges, "edge"));
}

void check_length(const std::string& option, double length) {
    if (!(length >= 0) || length > 1e6)
        throw Error::usage(fmt::format("{} {}: expected 0 to 1e6 metres", option, length));
}

void check_closed(std::span<const Aggregate> aggregates, std::span<const Location> places,
                  bool skip, Console& console) {
    std::vector<Diagnostic> problems;
    for (const OpenComponent& component : open_components(aggregates)) {
        const Location& place = places[component.aggregate];
        const std::string path = "generator." + aggregates[component.aggregate].generator;
        if (skip)
            console.say(fmt::format("left out {} of {}: {}",
                                    plural(component.instances, "instance"), path,
                                    problem_of(component)));
        else
            problems.push_back({place, path, problem_of(component),
                                "close it in a modelling program, or leave it out with --open "
                                "skip"});
    }
    if (!problems.empty())
        throw Error(Fault::input, problems);
}

} // namespace

void SolidOptions::add_to(CLI::App& command) {
    const CLI::AsNumberWithUnit metres(
        std::map<std::string, double>{{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"um", 1e-6}});
    const std::string group = "For .stl and .3mf";
    command
        .add_option("--resolution", resolution,
                    "Side of the lattice's cells, in metres or as in 0.2mm; a tenth of the "
                    "thinnest component by default")
        ->transform(metres)
        ->type_name("LENGTH")
        ->group(group);
    command
        .add_option("--bridge", bridge,
                    "Close gaps narrower than twice this, in metres or as in 0.5mm")
        ->transform(metres)
        ->type_name("LENGTH")
        ->group(group);
    command
        .add_option("--parts", parts,
                    "Of parts that are not connected: keep the largest, or keep all")
        ->check(CLI::IsMember({"largest", "keep"}))
        ->group(group);
    command.add_option("--voids", voids, "Enclosed voids: fill or keep them")
        ->check(CLI::IsMember({"fill", "keep"}))
        ->group(group);
    command
        .add_option("--open", open,
                    "Components that are not closed: stop with an error, or skip them")
        ->check(CLI::IsMember({"error", "skip"}))
        ->group(group);
}

Fabrication make_solid(std::span<const Aggregate> aggregates, std::span<const Location> places,
                       const SolidOptions& options, Console& console, const Cancel& cancel) {
    check_length("--resolution", options.resolution);
    check_length("--bridge", options.bridge);
    check_closed(aggregates, places, options.open == "skip", console);
    FabricationOptions wanted;
    wanted.resolution = options.resolution;
    wanted.bridge = options.bridge;
    wanted.keep_parts = options.parts == "keep";
    wanted.keep_voids = options.voids == "keep";
    Context context;
    context.cancel = &cancel;
    context.progress = [&](std::string_view what, double fraction) {
        console.progress("solid", fraction, " " + std::string(what));
    };
    Fabrication made = fabricate(aggregates, wanted, context);
    console.say(describe(made));
    say_removed(made, console);
    return made;
}

} // namespace scree
