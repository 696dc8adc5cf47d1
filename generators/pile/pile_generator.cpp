// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_generator.h"

#include "core/parallel.h"
#include "core/random.h"
#include "generators/located.h"
#include "generators/pile/insertion.h"
#include "generators/pile/pile_problem.h"
#include "generators/pile/pile_specs.h"

#include <chrono>

namespace scree {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<Instance> instances_of(const Pile& pile, std::uint64_t seed) {
    std::vector<Instance> instances(pile.all.size());
    parallel_for(pile.all.size(), 1024, [&](std::size_t i) {
        const Placed& placed = pile.all[i];
        instances[i].prototype = placed.kind;
        instances[i].world_from_object =
            world_from_object(placed.pose, pile.component(placed).origin);
        instances[i].random = Random(seed, Purpose::instance_attribute, i).uniform_float();
    });
    return instances;
}

Aggregate bake_pile(const Params& params, const Context& context) {
    const auto start = Clock::now();
    const auto seed = static_cast<std::uint64_t>(params.integer("seed"));
    const std::vector<PileKind> kinds = pile_kinds(params);
    const double preparing = seconds_since(start);
    const std::shared_ptr<const Mesh> target = params.mesh("target");
    const PileFrame frame =
        params.text("frame") == "global" ? PileFrame::global : PileFrame::surface;

    const auto sampling_start = Clock::now();
    const std::vector<PileSite> sites = located(
        params, "target", [&] { return pile_sites(*target, kinds, frame, seed, 0, context); });
    const double sampling = seconds_since(sampling_start);
    const auto placing_start = Clock::now();
    Pile pile(kinds);
    insert_components(
        pile, sites, {.overlap = params.number("overlap"), .sink = params.number("sink")}, context);
    const double placing = seconds_since(placing_start);

    Aggregate aggregate;
    aggregate.generator = "pile";
    aggregate.seed = seed;
    for (const PileKind& kind : kinds)
        aggregate.prototypes.push_back(kind.component.prototype);
    aggregate.instances = instances_of(pile, seed);
    aggregate.facts = {
        {"count", double(pile.all.size())}, {"dropped", double(sites.size() - pile.all.size())},
        {"preparing_seconds", preparing},   {"sampling_seconds", sampling},
        {"placing_seconds", placing},       {"seconds", seconds_since(start)}};
    return aggregate;
}

} // namespace

Plugin<Bake> pile_plugin() {
    return {"pile",
            "Heaps: components piled on the surface of a shape, touching and hardly overlapping "
            "(Sakurai 2013, chapter 4).",
            pile_specs(), bake_pile};
}

} // namespace scree
