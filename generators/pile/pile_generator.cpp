// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_generator.h"

#include "core/parallel.h"
#include "core/random.h"
#include "generators/pile/cover_target.h"
#include "generators/pile/kind_drafts.h"
#include "generators/pile/pile_facts.h"
#include "generators/pile/pile_settings.h"
#include "generators/pile/pile_specs.h"
#include "model/stage_times.h"

#include <fmt/format.h>

namespace scree {

namespace {

/// What takes the target's frame to the scene's.
WideMatrix scene_from_target(const PileSettings& settings) {
    WideMatrix matrix;
    matrix.rotate(WideVec3(0, settings.turn, 0));
    for (int axis = 0; axis < 3; ++axis)
        matrix[3][axis] = settings.position[axis];
    return matrix;
}

std::vector<Instance> instances_of(const PlacedBodies& pile, const PileSettings& settings) {
    const WideMatrix world = scene_from_target(settings);
    std::vector<Instance> instances(pile.all.size());
    parallel_for(pile.all.size(), 1024, [&](std::size_t i) {
        const PlacedBody& placed = pile.all[i];
        instances[i].prototype = placed.body;
        instances[i].world_from_object =
            WideMatrix(world_from_object(placed.pose, pile.body(placed).origin)) * world;
        instances[i].random = Random(settings.seed, Purpose::instance_attribute, i).uniform_float();
    });
    return instances;
}

/// The pile as placed, before any of it is removed.
struct PlacedPile {
    PlacedBodies pile;
    std::optional<PlacedBodies> strewn; // where relaxed components were before relaxation
    std::size_t tried = 0;
    std::optional<double> cover{}; // if measured
};

/// Warns where the components hide less of the target than was asked for.
void warn_of_cover(PlacedPile& placed, const PileSettings& settings) {
    constexpr double visible = 0.02; // less does not show
    if (!settings.warn_of_cover)
        return;
    placed.cover = measured_cover(placed.pile, *settings.target, settings.seed);
    if (*placed.cover < settings.cover - visible)
        settings.warn_of_cover(
            fmt::format("{:.0f}% of the surface is hidden, not the {:.0f}% asked for: nothing "
                        "more finds room",
                        100 * *placed.cover, 100 * settings.cover));
}

PlacedPile placed_at(std::vector<BodySite> sites, const PileSettings& settings,
                     const PileTurns& turns, const Context& context) {
    const Mesh& target = *settings.target;
    const Bodies bodies = bodies_of(turns.kinds);
    PlacedPile placed{.pile = PlacedBodies(bodies), .strewn = {}, .tried = 0};
    if (settings.thesis) {
        placed.tried = sites.size();
        place_by_thesis(placed.pile, turns.kinds, merge_large_to_small(turns.kinds, sites),
                        *settings.thesis, context);
        return placed;
    }
    if (settings.relaxation) {
        const Relaxed relaxed = relax(target, turns, *settings.relaxation, context);
        placed.tried = relaxed.start.size();
        placed.strewn.emplace(bodies);
        for (const PlacedBody& body : relaxed.start)
            placed.strewn->add(body);
        for (const PlacedBody& body : relaxed.all)
            placed.pile.add(body);
    }
    InsertionSettings insertion = settings.insertion;
    std::optional<Settler> settler;
    if (settings.settling)
        insertion.settler = &settler.emplace(bodies, target, *settings.settling);
    if (settings.solid) {
        placed.tried += fill_solid(placed.pile, target, turns, std::move(sites), *settings.solid,
                                   insertion, context);
        return placed;
    }
    const PileUp done =
        pile_up(placed.pile, target, turns, std::move(sites), insertion, settings.cover, context);
    placed.tried += done.tried;
    if (!done.covered)
        warn_of_cover(placed, settings);
    return placed;
}

void add_measures(const PlacedPile& placed, const PileSettings& settings, Facts& facts) {
    const PlacedBodies& pile = placed.pile;
    facts.emplace_back("cover", placed.cover
                                    ? *placed.cover
                                    : measured_cover(pile, *settings.target, settings.seed));
    if (settings.solid)
        facts.emplace_back("fill", filled_share(pile, *settings.target, settings.seed));
    add_overlap(pile, placed.strewn ? *placed.strewn : at_their_sites(pile), settings.measure,
                facts);
}

void check(const std::vector<ComponentSettings>& components) {
    for (const ComponentSettings& component : components) {
        located(component.shape_place, [&] { check_body(*component.shape, component.thickness); });
        if (component.variation)
            located(component.bend_place,
                    [&] { check_bend(*component.shape, *component.variation); });
    }
}

Aggregate bake_pile(const PileSettings& settings, const Context& context) {
    StageTimes stages;
    const KindDrafts drafts(settings.components, settings.seed);
    const std::vector<PileKind>& kinds = drafts.kinds;
    const PileTurns turns{.kinds = kinds,
                          .frame = settings.frame,
                          .flow = settings.flow ? &*settings.flow : nullptr,
                          .seed = settings.seed};
    stages.end("preparing");

    std::vector<BodySite> sites;
    // Sites depend on the components' sizes alone, so that the bodies can be completed meanwhile.
    parallel_for(kinds.size() + 1, 1, [&](std::size_t i) {
        if (i == 0)
            sites = located(settings.target_place,
                            [&] { return pile_sites(*settings.target, turns, context); });
        else
            drafts.complete(i - 1);
    });
    stages.end("sampling");

    PlacedPile placed = placed_at(std::move(sites), settings, turns, context);
    PlacedBodies& pile = placed.pile;
    const std::size_t count = pile.all.size();
    stages.end("placing");

    Facts support;
    check_support(pile, *settings.target, settings.support, support);
    if (!support.empty())
        stages.end("support");

    const std::optional<PlacedBodies> cut =
        settings.cut ? std::optional(cut_open(pile, *settings.cut)) : std::nullopt;
    const PlacedBodies& shown = cut ? *cut : pile;
    Aggregate aggregate;
    aggregate.generator = "pile";
    aggregate.seed = settings.seed;
    aggregate.prototypes = drafts.prototypes;
    aggregate.instances = instances_of(shown, settings);
    aggregate.facts = {{"count", double(shown.all.size())},
                       {"dropped", double(placed.tried - count)}};
    if (cut)
        aggregate.facts.emplace_back("cut", double(pile.all.size() - shown.all.size()));
    add_counts(shown, kinds, aggregate.facts);
    aggregate.facts.insert(aggregate.facts.end(), support.begin(), support.end());
    if (settings.measure > 0) {
        add_measures(placed, settings, aggregate.facts);
        stages.end("measuring");
    }
    stages.add_to(aggregate.facts);
    return aggregate;
}

} // namespace

Plugin<Generator> pile_plugin() {
    return {"pile",
            "Heaps: components piled on the surface of a shape, touching and hardly overlapping "
            "(Sakurai 2013, chapter 4).",
            pile_specs(), [](const Params& params) -> Bake {
                const auto settings = std::make_shared<const PileSettings>(pile_settings(params));
                check(settings->components);
                return [settings](const Context& context) { return bake_pile(*settings, context); };
            }};
}

} // namespace scree
