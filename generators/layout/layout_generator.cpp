// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/layout_generator.h"

#include "generators/layout/layout_specs.h"
#include "generators/layout/method.h"
#include "generators/layout/prototypes.h"
#include "geometry/plane/ground_plane.h"
#include "geometry/plane/region_shapes.h"

#include <fmt/format.h>

#include <chrono>

namespace scree {

namespace {

Inside inside_of(const Params& params) {
    if (params.flag("torus"))
        return Inside::torus;
    return params.text("inside") == "whole" ? Inside::whole : Inside::centre;
}

Range rotation_of(const Params& params) {
    if (params.has("rotation"))
        return params.range("rotation");
    return params.has("direction") ? Range{0, 0} : Range{0, 2 * pi};
}

LayoutFields fields_of(const Params& params) {
    return {field_of(params, "direction"), field_of(params, "scale_by"),
            field_of(params, "density"), field_of(params, "classes")};
}

void check_torus(const Params& params, const LayoutProblem& problem) {
    const Vec2 size = problem.domain.box().size();
    if (!is_rectangle(problem.domain.region()))
        throw params.error("torus", "the domain is no rectangle along x and z; only such tile");
    const double least = 4 * (problem.largest_radius() + problem.largest_margin());
    if (std::min(size.x, size.y) < least)
        throw params.error("torus",
                           fmt::format("the domain is {:.4g} m wide; with these components "
                                       "it must be {:.4g} m, so that none meets itself",
                                       std::min(size.x, size.y), least));
}

LayoutProblem problem_from(const Params& params, const std::vector<Prototype>& prototypes) {
    LayoutProblem problem{
        .domain = DomainTest(params.object<Region>("domain"), inside_of(params)),
        .fields = fields_of(params),
        .rotation = rotation_of(params),
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
        if (problem.fields.density)
            problem.margins.push_back(components[i].number("margin"));
        problem.classes.push_back(components[i].has("class")
                                      ? static_cast<long>(components[i].integer("class"))
                                      : static_cast<long>(i) + 1);
    }
    if (problem.domain.is_torus())
        check_torus(params, problem);
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
            world_from_element(problem.shapes[c].centre(), layout.position[i], layout.angle[i],
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
            {"queries", double(placements.queries() + counts.queries)},
            {"seconds", seconds}};
}

void add_certificate(const Certificate& certificate, Facts& facts) {
    facts.insert(facts.end() - 1,
                 {{"epsilon", certificate.epsilon},
                  {"cells", double(certificate.cells)},
                  {"undecided", double(certificate.undecided)},
                  {"certified", certificate.undecided == 0 && certificate.is_complete ? 1.0 : 0.0},
                  {"certificate_seconds", certificate.seconds}});
}

Aggregate bake_layout(const Params& params, const Context& context) {
    const auto start = std::chrono::steady_clock::now();
    if (!(area(*params.object<Region>("domain")) > 0))
        throw params.error("domain", "the domain has no area");
    Components components = components_from(
        params.list("components"), params.has("density") ? Margins::by_place : Margins::in_regions);
    const LayoutProblem problem = problem_from(params, components.prototypes);
    Placements placements(problem);
    MethodCounts counts;
    const std::string& method = params.text("method");
    std::optional<Certificate> certificate;
    const auto cancellations =
        static_cast<std::uint64_t>(params.has("cancellations") ? params.integer("cancellations")
                                   : method == "naive"         ? 10000
                                                               : 200);
    if (method == "naive") {
        counts = fill_naive(problem, cancellations, placements, context);
    } else if (method == "saturated") {
        const double epsilon = params.number("epsilon") * problem.smallest_inner_radius();
        try {
            counts = fill_saturated(problem, {.epsilon = epsilon}, placements,
                                    certificate.emplace(), context);
        } catch (const Error& error) {
            throw params.error("epsilon", error.diagnostics().front().message);
        }
    } else {
        counts = fill_gap(problem,
                          {.cancellations = cancellations,
                           .candidates = static_cast<std::size_t>(params.integer("candidates")),
                           .exponent = static_cast<std::uint32_t>(params.integer("exponent")),
                           .resolution = static_cast<int>(params.integer("resolution"))},
                          placements, context);
    }

    if (placements.size() == 0 && problem.max_count > 0)
        throw params.error("components",
                           certificate ? "none of them fits anywhere in the domain"
                                       : fmt::format("none of them found room in the domain in {} "
                                                     "trials",
                                                     counts.trials));

    const Layout layout = placements.layout(params.object<Region>("domain"));
    Aggregate aggregate;
    aggregate.generator = "layout";
    aggregate.seed = problem.seed;
    aggregate.prototypes = std::move(components.prototypes);
    aggregate.instances = instances_of(problem, layout, params.list("components"));
    aggregate.domain = layout.domain;
    aggregate.torus = problem.domain.is_torus();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    aggregate.facts = facts_of(problem, components.bare_areas, placements, counts, seconds.count());
    if (certificate)
        add_certificate(*certificate, aggregate.facts);
    return aggregate;
}

} // namespace

Plugin<Bake> layout_plugin() {
    return {"layout",
            "Components on a plane at random angles and scales, whose exclusive regions never "
            "overlap (Sakurai & Miyata 2014).",
            layout_specs(), bake_layout};
}

} // namespace scree
