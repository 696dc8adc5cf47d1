// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/layout_generator.h"

#include "core/located.h"
#include "generators/layout/layout_settings.h"
#include "generators/layout/layout_specs.h"
#include "generators/layout/prototypes.h"
#include "generators/layout/search_problem.h"
#include "geometry/plane/ground_plane.h"
#include "geometry/plane/region_shapes.h"

#include <fmt/format.h>

#include <chrono>

namespace scree {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// The component whose circumscribed circle with its margin is the largest.
std::size_t largest_component(const LayoutProblem& problem) {
    std::size_t largest = 0;
    double reach = 0;
    for (std::size_t i = 0; i < problem.shapes.size(); ++i) {
        const double own =
            problem.shapes[i].radius() + (problem.margins.empty() ? 0 : problem.margins[i]);
        if (own > reach) {
            reach = own;
            largest = i;
        }
    }
    return largest;
}

void check_torus(const LayoutSettings& settings, const LayoutProblem& problem,
                 const std::vector<Prototype>& prototypes) {
    const Vec2 size = problem.domain.box().size();
    if (!is_rectangle(problem.domain.region()))
        throw settings.torus_place.error(
            "the domain is no rectangle along x and z; only such tile");
    const double least = 4 * (problem.largest_radius() + problem.largest_margin());
    if (std::min(size.x, size.y) >= least)
        return;
    const std::size_t largest = largest_component(problem);
    throw settings.torus_place.error(
        fmt::format("the domain is {:.4g} m wide; with these components it must be {:.4g} m, so "
                    "that none meets itself",
                    std::min(size.x, size.y), least),
        fmt::format("the largest is components[{}], {}", largest + 1, prototypes[largest].name));
}

LayoutProblem problem_from(const LayoutSettings& settings,
                           const std::vector<Prototype>& prototypes) {
    LayoutProblem problem{
        .selection = settings.selection,
        .domain = DomainTest(settings.domain, settings.inside),
        .fields = settings.fields,
        .rotation = settings.rotation,
        .scale = settings.scale,
        .seed = settings.seed,
        .max_count = settings.max_count,
    };
    for (std::size_t i = 0; i < prototypes.size(); ++i) {
        const LayoutComponent& component = settings.components[i];
        problem.shapes.emplace_back(*prototypes[i].region);
        problem.weights.push_back(component.weight);
        if (problem.fields.density)
            problem.margins.push_back(component.margin);
        problem.classes.push_back(component.class_number);
    }
    if (problem.domain.is_torus())
        check_torus(settings, problem, prototypes);
    if (problem.domain.inside() == Inside::whole)
        for (std::size_t i = 0; i < prototypes.size(); ++i)
            located(settings.components[i].shape_place,
                    [&] { check_fits(problem, i, prototypes[i].name); });
    return problem;
}

std::vector<Instance> instances_of(const LayoutProblem& problem, const Layout& layout,
                                   const std::vector<LayoutComponent>& components) {
    std::vector<Instance> instances(layout.size());
    for (std::size_t i = 0; i < layout.size(); ++i) {
        const std::uint32_t c = layout.component[i];
        instances[i].prototype = c;
        instances[i].world_from_object =
            world_from_element(problem.shapes[c].centre(), layout.position[i], layout.angle[i],
                               layout.scale[i], components[c].height);
        instances[i].random = Random(problem.seed, Purpose::instance_attribute, i).uniform_float();
        instances[i].angle = layout.angle[i];
        instances[i].scale = layout.scale[i];
    }
    return instances;
}

double epsilon_of(const LayoutSettings& settings, const LayoutProblem& problem) {
    return settings.epsilon_share * problem.smallest_inner_radius();
}

/// Fills the domain by the method that the settings name; `certificate` is set by the saturated
/// one.
MethodCounts fill(LayoutMethod method, const LayoutSettings& settings, const LayoutProblem& problem,
                  Placements& placements, std::optional<Certificate>& certificate,
                  const Context& context) {
    switch (method) {
    case LayoutMethod::naive:
        return fill_naive(problem, settings.naive_cancellations, placements, context);
    case LayoutMethod::saturated:
        return located(settings.epsilon_place, [&] {
            return fill_saturated(problem, {.epsilon = epsilon_of(settings, problem)}, placements,
                                  certificate.emplace(), context);
        });
    case LayoutMethod::fill_gap:
        break;
    }
    return fill_gap(problem, settings.fill_gap, placements, context);
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

/// Saturated where that takes seconds; not when a number of elements or of darts is asked for,
/// which are to be spread evenly, or to end the work.
LayoutMethod default_method(const LayoutSettings& settings, const LayoutProblem& problem) {
    constexpr double longest = 10; // [s]
    const bool limited =
        settings.counts_darts || settings.max_count != std::numeric_limits<std::size_t>::max();
    return limited || expected_seconds(problem) > longest ? LayoutMethod::fill_gap
                                                          : LayoutMethod::saturated;
}

/// What is known before anything is placed.
struct PreparedLayout {
    explicit PreparedLayout(const Params& params) : settings(layout_settings(params)) {
        const auto start = Clock::now();
        if (!(area(*settings.domain) > 0))
            throw settings.domain_place.error("the domain has no area");
        components = components_from(
            settings.components, settings.fields.density ? Margins::by_place : Margins::in_regions);
        problem.emplace(problem_from(settings, components.prototypes));
        method = settings.method ? *settings.method : default_method(settings, *problem);
        if (method == LayoutMethod::saturated)
            located(settings.epsilon_place,
                    [&] { check_epsilon(*problem, epsilon_of(settings, *problem)); });
        preparing = Clock::now() - start;
    }

    LayoutSettings settings;
    Components components;
    std::optional<LayoutProblem> problem;
    LayoutMethod method = LayoutMethod::saturated;
    Seconds preparing{};
};

Aggregate bake_layout(const PreparedLayout& prepared, const Context& context) {
    const auto start = Clock::now();
    const LayoutSettings& settings = prepared.settings;
    const Components& components = prepared.components;
    const LayoutProblem& problem = *prepared.problem;
    Placements placements(problem);
    std::optional<Certificate> certificate;
    const MethodCounts counts =
        fill(prepared.method, settings, problem, placements, certificate, context);
    if (placements.size() == 0 && problem.max_count > 0)
        throw settings.components_place.error(
            certificate
                ? "none of them fits anywhere in the domain"
                : fmt::format("none of them found room in the domain in {} trials", counts.trials));

    const Layout layout = placements.layout(settings.domain);
    Aggregate aggregate;
    aggregate.generator = "layout";
    aggregate.seed = problem.seed;
    aggregate.prototypes = components.prototypes;
    aggregate.instances = instances_of(problem, layout, settings.components);
    aggregate.domain = layout.domain;
    aggregate.torus = problem.domain.is_torus();
    const Seconds seconds = prepared.preparing + (Clock::now() - start);
    aggregate.facts = facts_of(problem, components.bare_areas, placements, counts, seconds.count());
    if (certificate)
        add_certificate(*certificate, aggregate.facts);
    return aggregate;
}

} // namespace

Plugin<Generator> layout_plugin() {
    return {"layout",
            "Components on a plane at random angles and scales, whose exclusive regions never "
            "overlap (Sakurai & Miyata 2014).",
            layout_specs(), [](const Params& params) -> Bake {
                return [prepared = std::make_shared<const PreparedLayout>(params)](
                           const Context& context) { return bake_layout(*prepared, context); };
            }};
}

} // namespace scree
