// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_generator.h"

#include "core/located.h"
#include "core/parallel.h"
#include "core/random.h"
#include "generators/pile/cover_target.h"
#include "generators/pile/pile_problem.h"
#include "generators/pile/pile_relax.h"
#include "generators/pile/pile_solid.h"
#include "generators/pile/pile_specs.h"
#include "generators/pile/pile_support.h"
#include "generators/pile/thesis_method.h"
#include "geometry/bodies/insertion.h"
#include "geometry/bodies/overlap_measure.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>

namespace scree {

namespace {

using Clock = std::chrono::steady_clock;

// Where the whole pile stands.
Matrix placement(const Params& params) {
    Matrix matrix;
    matrix.rotate(Vec3(0, static_cast<float>(params.number("turn")), 0));
    const Vec3 at = params.vector3("position");
    matrix[3][0] = at.x;
    matrix[3][1] = at.y;
    matrix[3][2] = at.z;
    return matrix;
}

std::vector<Instance> instances_of(const Pile& pile, std::uint64_t seed, const Matrix& world) {
    std::vector<Instance> instances(pile.all.size());
    parallel_for(pile.all.size(), 1024, [&](std::size_t i) {
        const Placed& placed = pile.all[i];
        instances[i].prototype = placed.kind;
        instances[i].world_from_object =
            world_from_object(placed.pose, pile.component(placed).origin) * world;
        instances[i].random = Random(seed, Purpose::instance_attribute, i).uniform_float();
    });
    return instances;
}

/// Seconds by stage, each from the end of the one before.
class Stages {
  public:
    void end(const char* name) {
        const Clock::time_point now = Clock::now();
        seconds_.emplace_back(std::string(name) + "_seconds",
                              std::chrono::duration<double>(now - last_).count());
        last_ = now;
    }
    void add_to(Facts& facts) const {
        facts.insert(facts.end(), seconds_.begin(), seconds_.end());
        facts.emplace_back("seconds", std::chrono::duration<double>(last_ - start_).count());
    }

  private:
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    Facts seconds_;
};

Pile at_start(const Pile& pile) {
    Pile start(pile.kinds);
    for (Placed placed : pile.all) {
        placed.pose.centre -= Imath::V3d(placed.normal) * placed.height;
        placed.height = 0;
        start.add(placed);
    }
    return start;
}

void add_overlap(const Pile& pile, const Pile& start, std::size_t most, Facts& facts) {
    constexpr std::size_t volume_samples = 400;
    const OverlapMeasure before = measure_overlap(start, most, 0);
    const OverlapMeasure after = measure_overlap(pile, most, volume_samples);
    facts.insert(facts.end(), {{"measured", double(after.measured)},
                               {"start_depth_mean", before.mean_depth},
                               {"start_depth_99", before.percentile_99},
                               {"start_depth_max", before.largest_depth},
                               {"depth_mean", after.mean_depth},
                               {"depth_99", after.percentile_99},
                               {"depth_max", after.largest_depth},
                               {"volume_overlap", after.volume_share}});
}

InsertionSettings insertion_settings(const Params& params) {
    if (params.has("removal"))
        throw params.error("removal", "is a parameter of the thesis's method",
                           "expected method = \"thesis\" beside it");
    return {.overlap = params.number("overlap"), .sink = params.number("sink")};
}

// Nothing where components stay where they came free.
std::optional<SettleSettings> settle_settings(const Params& params) {
    const auto steps = static_cast<int>(params.integer("settle"));
    if (steps == 0)
        return {};
    if (params.text("method") != "insertion" || params.text("fill") != "surface")
        throw params.error("settle", "is for what is inserted on a surface",
                           "expected method = \"insertion\" and fill = \"surface\" beside it");
    SettleSettings settings{
        .steps = steps, .sink = params.number("sink"), .overlap = params.number("overlap")};
    if (params.has("settle_turn"))
        settings.turn = params.number("settle_turn");
    else if (params.text("frame") != "surface")
        settings.turn = 0;
    return settings;
}

ThesisSettings thesis_settings(const Params& params) {
    if (params.number("sink") > 0)
        throw params.error("sink", "is no parameter of the thesis's method");
    ThesisSettings settings;
    settings.overlap = params.number("overlap");
    if (params.has("removal"))
        settings.removal = params.number("removal");
    return settings;
}

// By component, where there are several.
void add_counts(const Pile& pile, Facts& facts) {
    std::vector<std::size_t> component_of;
    std::size_t components = 0;
    for (const PileKind& kind : pile.kinds) {
        components += kind.shapes > 0;
        component_of.push_back(components - 1);
    }
    std::vector<double> counts(components, 0);
    for (const Placed& placed : pile.all)
        ++counts[component_of[placed.kind]];
    for (std::size_t k = 0; counts.size() > 1 && k < counts.size(); ++k)
        facts.emplace_back(fmt::format("count_{}", k + 1), counts[k]);
}

std::optional<OrientationFlow> flow_of(const Params& params) {
    const bool follows = params.text("frame") == "flow";
    if (follows && !params.has("flow"))
        throw params.error("frame", "is \"flow\", but there is none",
                           "expected flow = { ... } beside it");
    if (!follows && params.has("flow"))
        throw params.error("flow", "is given, but nothing follows it",
                           "expected frame = \"flow\" beside it");
    if (!follows)
        return {};
    return orientation_flow(params.record("flow"));
}

/// What the parameters ask for: all that can be wrong with them by themselves is told before
/// anything is prepared.
struct PileSettings {
    explicit PileSettings(const Params& params)
        : solid(solid_fill(params)), relaxation(relax_settings(params)),
          settling(settle_settings(params)), flow(flow_of(params)), cut(cut_plane(params)) {
        if (params.text("method") == "thesis")
            thesis = thesis_settings(params);
        else if (!relaxation)
            insertion = insertion_settings(params);
    }

    std::optional<SolidFill> solid;
    std::optional<RelaxSettings> relaxation;
    std::optional<ThesisSettings> thesis;
    InsertionSettings insertion;
    std::optional<SettleSettings> settling;
    std::optional<OrientationFlow> flow;
    std::optional<CutPlane> cut;
};

Aggregate bake_pile(const Params& params, const Context& context) {
    Stages stages;
    const auto seed = static_cast<std::uint64_t>(params.integer("seed"));
    const PileSettings settings(params);
    PileKinds drafts(params);
    const std::vector<PileKind>& kinds = drafts.kinds;
    const PileTurns turns{.kinds = kinds,
                          .frame = params.text("frame") == "global" ? PileFrame::global
                                                                    : PileFrame::surface,
                          .flow = settings.flow ? &*settings.flow : nullptr,
                          .seed = seed};
    stages.end("preparing");

    const std::shared_ptr<const Mesh> target = params.object<Mesh>("target");
    std::vector<PileSite> sites;
    // Sites go by the components' sizes alone, so that the rest of these is made meanwhile.
    parallel_for(kinds.size() + 1, 1, [&](std::size_t i) {
        if (i == 0)
            sites = located(params, "target", [&] { return pile_sites(*target, turns, context); });
        else
            drafts.complete(i - 1);
    });
    stages.end("sampling");

    Pile pile(kinds);
    std::size_t tried = sites.size();
    std::optional<Pile> strewn;
    if (settings.relaxation) {
        strewn.emplace(kinds);
        tried = place_relaxed(pile, *strewn, *target, turns, std::move(sites), *settings.relaxation,
                              settings.solid, params.number("cover"), context);
    } else if (settings.thesis) {
        place_by_thesis(pile, merge_large_to_small(kinds, sites), *settings.thesis, context);
    } else if (settings.solid) {
        tried = fill_solid(pile, *target, turns, std::move(sites), *settings.solid,
                           settings.insertion, context);
    } else {
        InsertionSettings insertion = settings.insertion;
        std::optional<Settler> settler;
        if (settings.settling)
            insertion.settler = &settler.emplace(kinds, *target, *settings.settling);
        tried = pile_up(pile, *target, turns, std::move(sites), insertion, params.number("cover"),
                        context);
    }
    stages.end("placing");

    const std::size_t placed = pile.all.size();
    Facts support;
    check_support(pile, params, support);
    if (!support.empty())
        stages.end("support");

    Aggregate aggregate;
    aggregate.generator = "pile";
    aggregate.seed = seed;
    for (const PileKind& kind : kinds)
        aggregate.prototypes.push_back(kind.component.prototype);
    const std::optional<Pile> cut =
        settings.cut ? std::optional(cut_open(pile, *settings.cut)) : std::nullopt;
    const Pile& shown = cut ? *cut : pile;
    aggregate.instances = instances_of(shown, seed, placement(params));
    aggregate.facts = {{"count", double(shown.all.size())}, {"dropped", double(tried - placed)}};
    if (cut)
        aggregate.facts.emplace_back("cut", double(pile.all.size() - shown.all.size()));
    add_counts(shown, aggregate.facts);
    aggregate.facts.insert(aggregate.facts.end(), support.begin(), support.end());
    if (params.integer("measure") > 0) {
        aggregate.facts.emplace_back("cover", measured_cover(pile, *target, seed));
        if (settings.solid)
            aggregate.facts.emplace_back("fill", filled_share(pile, *target, seed));
        add_overlap(pile, strewn ? *strewn : at_start(pile),
                    static_cast<std::size_t>(params.integer("measure")), aggregate.facts);
        stages.end("measuring");
    }
    stages.add_to(aggregate.facts);
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
