// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/layout_generator.h"

#include "generators/layout/method.h"
#include "generators/layout/prototypes.h"

#include <chrono>

namespace scree {

namespace {

LayoutProblem problem_from(const Params& params, const std::vector<Prototype>& prototypes) {
    LayoutProblem problem{
        .domain = DomainTest(params.region("domain"),
                             params.text("inside") == "whole" ? Inside::whole : Inside::centre),
        .rotation = params.range("rotation"),
        .scale = params.range("scale"),
        .seed = static_cast<std::uint64_t>(params.integer("seed")),
    };
    if (params.has("max_count"))
        problem.max_count = static_cast<std::size_t>(params.integer("max_count"));
    const std::vector<Params>& components = params.list("components");
    bool weights_differ = false;
    for (std::size_t i = 0; i < components.size(); ++i) {
        problem.shapes.emplace_back(*prototypes[i].region);
        problem.weights.push_back(components[i].number("weight"));
        weights_differ = weights_differ || problem.weights[i] != problem.weights[0];
    }
    const std::string selection = params.has("selection") ? params.text("selection")
                                  : weights_differ        ? "weighted"
                                                          : "cyclic";
    problem.selection = selection == "cyclic" ? Selection::cyclic : Selection::weighted;
    if (problem.domain.inside() == Inside::whole) {
        for (std::size_t i = 0; i < components.size(); ++i) {
            try {
                check_fits(problem, i, prototypes[i].name);
            } catch (const Error& error) {
                throw components[i].error("shape", error.diagnostics().front().message);
            }
        }
    }
    return problem;
}

std::vector<Instance> instances_of(const LayoutProblem& problem, const Layout& layout,
                                   const std::vector<Params>& components) {
    std::vector<Instance> instances(layout.size());
    for (std::size_t i = 0; i < layout.size(); ++i) {
        const std::uint32_t c = layout.component[i];
        instances[i].prototype = c;
        instances[i].world_from_object =
            world_from_component(problem.shapes[c].centre(), layout.position[i], layout.angle[i],
                                 layout.scale[i], components[c].number("height"));
        instances[i].random = Random(problem.seed, Purpose::instance_attribute, i).uniform_float();
        instances[i].angle = static_cast<float>(layout.angle[i]);
        instances[i].scale = static_cast<float>(layout.scale[i]);
    }
    return instances;
}

Facts facts_of(const LayoutProblem& problem, const std::vector<double>& bare_areas,
               const Placements& placements, const MethodCounts& counts, double seconds) {
    double bare = 0, exclusive = 0;
    for (const Dart& dart : placements.darts()) {
        const double scale2 = dart.pose.scale * dart.pose.scale;
        bare += bare_areas[dart.component] * scale2;
        exclusive += problem.shapes[dart.component].area() * scale2;
    }
    const double domain = area(problem.domain.region());
    return {{"count", double(placements.size())},
            {"fill", bare / domain},
            {"fill_with_margin", exclusive / domain},
            {"trials", double(counts.trials)},
            {"cancellations", double(counts.cancellations)},
            {"queries", double(placements.queries())},
            {"seconds", seconds}};
}

Aggregate bake_layout(const Params& params, const Context& context) {
    const auto start = std::chrono::steady_clock::now();
    if (!(area(*params.region("domain")) > 0))
        throw params.error("domain", "the domain has no area");
    Components components = components_from(params.list("components"));
    const LayoutProblem problem = problem_from(params, components.prototypes);
    Placements placements(problem);
    MethodCounts counts;
    const bool is_naive = params.text("method") == "naive";
    const auto cancellations =
        static_cast<std::uint64_t>(params.has("cancellations") ? params.integer("cancellations")
                                   : is_naive                  ? 10000
                                                               : 200);
    if (is_naive)
        counts = fill_naive(problem, cancellations, placements, context);
    else
        counts = fill_gap(problem,
                          {.cancellations = cancellations,
                           .candidates = static_cast<std::size_t>(params.integer("candidates")),
                           .exponent = static_cast<std::uint32_t>(params.integer("exponent")),
                           .resolution = static_cast<int>(params.integer("resolution"))},
                          placements, context);

    const Layout layout = placements.layout(params.region("domain"));
    Aggregate aggregate;
    aggregate.generator = "layout";
    aggregate.seed = problem.seed;
    aggregate.prototypes = std::move(components.prototypes);
    aggregate.instances = instances_of(problem, layout, params.list("components"));
    aggregate.domain = layout.domain;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    aggregate.facts = facts_of(problem, components.bare_areas, placements, counts, seconds.count());
    return aggregate;
}

std::vector<ParamSpec> component_specs() {
    return {
        {.name = "shape",
         .type = ParamType::shape,
         .doc = "What is placed: a mesh, or a region, which becomes a flat mesh."},
        {.name = "region",
         .type = ParamType::region,
         .doc = "The exclusive region in place of the shape's own; for a mesh that is its "
                "silhouette from above.",
         .optional = true},
        {.name = "material",
         .type = ParamType::material,
         .doc = "Its material.",
         .fallback = MaterialId{}},
        {.name = "weight",
         .type = ParamType::number,
         .doc = "How often it is tried, relative to the others.",
         .fallback = 1.0,
         .min = 0.0,
         .max = 1e6,
         .above_min = true},
        {.name = "margin",
         .type = ParamType::number,
         .doc = "Grows the exclusive region all round, or shrinks it when negative, before "
                "scaling.",
         .unit = "m",
         .fallback = 0.0},
        {.name = "height",
         .type = ParamType::number,
         .doc = "Lifts the component above the ground.",
         .unit = "m",
         .fallback = 0.0},
    };
}

std::vector<ParamSpec> layout_specs() {
    return {
        {.name = "method",
         .type = ParamType::choice,
         .doc = "naive: random darts; fill_gap: darts where the gaps are wide.",
         .fallback = std::string("fill_gap"),
         .choices = {"naive", "fill_gap"}},
        {.name = "domain", .type = ParamType::region, .doc = "Where elements may lie."},
        {.name = "components",
         .type = ParamType::list,
         .doc = "What is placed.",
         .fields = component_specs(),
         .min_items = 1},
        {.name = "selection",
         .type = ParamType::choice,
         .doc = "cyclic: each trial takes the next component; weighted: at random by weight. "
                "Cyclic unless the weights differ.",
         .optional = true,
         .choices = {"cyclic", "weighted"}},
        {.name = "inside",
         .type = ParamType::choice,
         .doc = "whole: no part of a region sticks out of the domain; centre: its centre may not.",
         .fallback = std::string("whole"),
         .choices = {"whole", "centre"}},
        {.name = "rotation",
         .type = ParamType::range,
         .doc = "Angles, from +x towards +z.",
         .unit = "deg",
         .fallback = Range{0, 2 * pi}},
        {.name = "scale",
         .type = ParamType::range,
         .doc = "Uniform scales.",
         .fallback = Range{1, 1},
         .min = 1e-6,
         .max = 1e6},
        {.name = "seed",
         .type = ParamType::integer,
         .doc = "Another seed, another layout.",
         .fallback = std::int64_t{0},
         .min = 0.0},
        {.name = "cancellations",
         .type = ParamType::integer,
         .doc = "Cancelled trials in a row that end the work: 10000 for naive, 200 for fill_gap.",
         .optional = true,
         .min = 1.0,
         .max = 1e12},
        {.name = "candidates",
         .type = ParamType::integer,
         .doc = "fill_gap: points tried per distance field.",
         .fallback = std::int64_t{100},
         .min = 1.0,
         .max = 1e6},
        {.name = "exponent",
         .type = ParamType::integer,
         .doc = "fill_gap: power of the normalised distance that is a pixel's probability.",
         .fallback = std::int64_t{16},
         .min = 0.0,
         .max = 1024.0},
        {.name = "resolution",
         .type = ParamType::integer,
         .doc = "fill_gap: pixels of the distance field along the domain's longest side.",
         .fallback = std::int64_t{512},
         .min = 16.0,
         .max = 8192.0},
        {.name = "max_count",
         .type = ParamType::integer,
         .doc = "Stops at this many elements.",
         .optional = true,
         .min = 0.0},
    };
}

} // namespace

Plugin<Bake> layout_plugin() {
    return {"layout",
            "Components on a plane at random angles and scales, whose exclusive regions never "
            "overlap (Sakurai & Miyata 2014).",
            layout_specs(), bake_layout};
}

} // namespace scree
