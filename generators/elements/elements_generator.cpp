// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/elements/elements_generator.h"

#include "core/located.h"
#include "core/parallel.h"
#include "core/random.h"
#include "generators/elements/element_kinds.h"
#include "generators/elements/element_shapes.h"
#include "generators/elements/elements_on_surface.h"
#include "generators/elements/elements_specs.h"
#include "geometry/plane/field.h"
#include "geometry/plane/ground_plane.h"
#include "geometry/plane/region_shapes.h"
#include "geometry/plane/region_tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace scree {

namespace {

using Clock = std::chrono::steady_clock;

/// What multiplies the distances: the elements' scale and their spacing.
std::shared_ptr<const Field> distance_scale(const Params& params) {
    const std::shared_ptr<const Field> scale = field_of(params, "scale_by");
    const std::shared_ptr<const Field> spacing = field_of(params, "spacing_by");
    return scale && spacing ? std::make_shared<const ProductField>(scale, spacing)
           : scale          ? scale
                            : spacing;
}

/// The domain less what is too near to its border for the farthest-reaching element.
std::shared_ptr<const Region> inner_domain(const Params& params,
                                           const std::vector<ElementShape>& shapes) {
    const std::shared_ptr<const Region> domain = params.object<Region>("domain");
    const auto farthest =
        std::max_element(shapes.begin(), shapes.end(),
                         [](const auto& a, const auto& b) { return a.reach < b.reach; });
    const double scale =
        params.has("scale_by") ? field_of(params, "scale_by")->over(bounds(*domain)).high : 1;
    const double reach = farthest->reach * scale;
    if (reach <= 0)
        return domain;
    try {
        // What it is eroded by is a polygon of 32 corners inscribed in a disk.
        return std::make_shared<const Region>(offset(*domain, -reach / std::cos(pi / 32)));
    } catch (const Error&) {
        const std::size_t i = std::size_t(farthest - shapes.begin());
        throw params.list("components")[i].error(
            "shape", fmt::format("reaches {:.4g} m from its centre; a disk of that radius fits "
                                 "nowhere in the domain",
                                 reach));
    }
}

PoissonDiskProblem problem_from(const Params& params, const std::vector<ElementShape>& shapes) {
    const std::shared_ptr<const Region> domain = params.object<Region>("domain");
    if (!(area(*domain) > 0))
        throw params.error("domain", "the domain has no area");
    const bool torus = params.flag("torus");
    if (torus && !is_rectangle(*domain))
        throw params.error("torus", "the domain is no rectangle along x and z; only such tile");
    return {
        .domain =
            !torus && params.text("inside") == "whole" ? inner_domain(params, shapes) : domain,
        .torus = torus,
        .classes = disk_classes(params, shapes),
        .direction = field_of(params, "direction"),
        .scale = distance_scale(params),
        .seed = static_cast<std::uint64_t>(params.integer("seed")),
        .relax = static_cast<int>(params.integer("relax")),
        .kept = {},
        .window = {},
    };
}

std::vector<Instance> instances_of(const std::vector<DiskSample>& samples,
                                   const std::vector<std::uint32_t>& components,
                                   const std::vector<ElementShape>& shapes, std::uint64_t seed) {
    std::vector<Instance> instances(samples.size());
    parallel_for(samples.size(), 1024, [&](std::size_t i) {
        const DiskSample& sample = samples[i];
        const ElementShape& shape = shapes[components[i]];
        instances[i].prototype = components[i];
        instances[i].world_from_object = world_from_element(
            shape.centre, sample.position, sample.angle, sample.scale, shape.height);
        instances[i].random = Random(seed, Purpose::instance_attribute, i).uniform_float();
        instances[i].angle = sample.angle;
        instances[i].scale = sample.scale;
    });
    return instances;
}

/// `fill_with_margin` counts the halves of the ellipses, which are what does not overlap when all
/// elements point the same way. Evenly mixed classes of given sizes come nearer to each other than
/// to their own kind, so that there it means nothing and is left out; as where the spacing varies.
Facts facts_of(const Params& params, const std::vector<ElementShape>& shapes,
               const PoissonDiskSet& set, const std::vector<std::uint32_t>& components) {
    double bare = 0, exclusive = 0;
    for (std::size_t i = 0; i < set.samples.size(); ++i) {
        const ElementShape& shape = shapes[components[i]];
        const double scale2 = set.samples[i].scale * set.samples[i].scale;
        bare += shape.area * scale2;
        exclusive += pi / 4 * shape.room.exclusive.length * shape.room.exclusive.width * scale2;
    }
    const double domain = area(*params.object<Region>("domain"));
    Facts facts{{"count", double(set.samples.size())}, {"fill", bare / domain}};
    const bool overlap_within =
        shapes.size() > 1 && params.text("mix") == "even" && shapes.front().sized;
    if (!overlap_within && !params.has("spacing_by"))
        facts.emplace_back("fill_with_margin", exclusive / domain);
    facts.emplace_back("trials", double(set.trials));
    facts.emplace_back("unresolved", double(set.unresolved));
    add_shares(components, shapes.size(), facts);
    return facts;
}

std::shared_ptr<const Picture> background_of(const Params& params) {
    if (!params.has("background"))
        return nullptr;
    return located(params, "background", [&] {
        Picture picture = read_picture(params.text("background"));
        picture.box = bounds(*params.object<Region>("domain"));
        return std::make_shared<const Picture>(std::move(picture));
    });
}

Aggregate bake_elements(const Params& params, const Context& context) {
    const auto start = Clock::now();
    if (params.has("domain") == params.has("surface"))
        throw params.error(params.has("domain") ? "surface" : "domain",
                           params.has("domain") ? "is given beside a domain; one of them will do"
                                                : "is missing, and there is no surface either",
                           params.has("domain") ? ""
                                                : "expected a region.*, or surface = a mesh.*");
    const std::vector<ElementShape> shapes = element_shapes(params);
    if (params.has("surface"))
        return bake_on_surface(params, shapes, context);
    const PoissonDiskProblem problem = problem_from(params, shapes);
    const auto sampling_start = Clock::now();
    PoissonDiskSet set = located(params, problem.torus ? "torus" : "components",
                                 [&] { return sample_poisson_disks(problem, context); });
    const std::chrono::duration<double> sampling = Clock::now() - sampling_start;
    if (params.has("spacing_by"))
        for (DiskSample& sample : set.samples)
            sample.scale =
                params.has("scale_by") ? field_of(params, "scale_by")->at(sample.position) : 1;
    std::vector<std::uint32_t> classes;
    for (const DiskSample& sample : set.samples)
        classes.push_back(sample.disk_class);
    const std::vector<std::uint32_t> components =
        components_of(classes, shapes, problem.classes.size(), problem.seed);

    Aggregate aggregate;
    aggregate.generator = "elements";
    aggregate.seed = problem.seed;
    for (const ElementShape& shape : shapes)
        aggregate.prototypes.push_back(shape.prototype);
    aggregate.instances = instances_of(set.samples, components, shapes, problem.seed);
    aggregate.domain = params.object<Region>("domain");
    aggregate.background = background_of(params);
    aggregate.torus = problem.torus;
    aggregate.texture = true;
    aggregate.facts = facts_of(params, shapes, set, components);
    aggregate.facts.emplace_back("sampling_seconds", sampling.count());
    const std::chrono::duration<double> seconds = Clock::now() - start;
    aggregate.facts.emplace_back("seconds", seconds.count());
    return aggregate;
}

} // namespace

Plugin<Bake> elements_plugin() {
    return {"elements",
            "Discrete element textures: components evenly spread over a region, by maximal "
            "Poisson-disk sampling (Kita & Miyata 2012).",
            elements_specs(), bake_elements};
}

} // namespace scree
