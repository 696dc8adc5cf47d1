// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/elements/elements_generator.h"

#include "core/located.h"
#include "core/parallel.h"
#include "core/random.h"
#include "generators/elements/element_kinds.h"
#include "generators/elements/element_shapes.h"
#include "generators/elements/elements_on_surface.h"
#include "generators/elements/elements_settings.h"
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
using Seconds = std::chrono::duration<double>;

/// What multiplies the distances: the elements' scale and their spacing.
std::shared_ptr<const Field> distance_scale(const ElementsSettings& settings) {
    if (settings.scale && settings.spacing)
        return std::make_shared<const ProductField>(settings.scale, settings.spacing);
    return settings.scale ? settings.scale : settings.spacing;
}

/// The domain less what is too near to its border for the farthest-reaching element.
std::shared_ptr<const Region> inner_domain(const ElementsSettings& settings,
                                           const std::vector<ElementShape>& shapes) {
    const std::shared_ptr<const Region>& domain = settings.domain;
    const auto farthest =
        std::max_element(shapes.begin(), shapes.end(),
                         [](const auto& a, const auto& b) { return a.reach < b.reach; });
    const double scale = settings.scale ? settings.scale->over(bounds(*domain)).high : 1;
    const double reach = farthest->reach * scale;
    if (reach <= 0)
        return domain;
    try {
        // `offset` erodes by a polygon of 32 corners that is inscribed in a disk.
        return std::make_shared<const Region>(offset(*domain, -reach / std::cos(pi / 32)));
    } catch (const Error& error) {
        if (error.fault() != Fault::input)
            throw;
        const std::size_t i = std::size_t(farthest - shapes.begin());
        throw settings.components[i].shape_place.error(
            fmt::format("reaches {:.4g} m from its centre; a disk of that radius fits nowhere in "
                        "the domain",
                        reach));
    }
}

/// Which component keeps the others farthest away, and why.
std::string longest_distance(const ElementsSettings& settings, const PoissonDiskProblem& problem,
                             const std::vector<ElementShape>& shapes) {
    const bool one_class = problem.classes.size() == 1; // of all components
    std::size_t farthest = 0;
    double longest = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const EllipseAxes& own = shapes[i].room.exclusive;
        const double length = one_class
                                  ? std::max(own.length, own.width)
                                  : std::max(problem.classes[i].length, problem.classes[i].width);
        if (length > longest) {
            longest = length;
            farthest = i;
        }
    }
    const double weight = settings.components[farthest].weight;
    const bool rare = !one_class && std::ranges::any_of(settings.components, [&](const auto& c) {
        return c.weight > weight;
    });
    return fmt::format("the longest distance, {:.4g} m, is that of components[{}]{}", longest,
                       farthest + 1,
                       rare ? fmt::format("; its weight of {:.4g}, less than others', makes it "
                                          "rare and its distance long",
                                          weight)
                            : "");
}

void check_tile(const ElementsSettings& settings, const PoissonDiskProblem& problem,
                const std::vector<ElementShape>& shapes) {
    try {
        check_torus(problem);
    } catch (const Error& error) {
        throw settings.torus_place.error(error.diagnostics().front().message,
                                         longest_distance(settings, problem, shapes));
    }
}

PoissonDiskProblem problem_from(const ElementsSettings& settings,
                                const std::vector<ElementShape>& shapes) {
    const std::shared_ptr<const Region>& domain = settings.domain;
    if (!(area(*domain) > 0))
        throw settings.domain_place.error("the domain has no area");
    if (settings.torus && !is_rectangle(*domain))
        throw settings.torus_place.error(
            "the domain is no rectangle along x and z; only such tile");
    PoissonDiskProblem problem{
        .domain =
            !settings.torus && settings.whole_inside ? inner_domain(settings, shapes) : domain,
        .torus = settings.torus,
        .classes = disk_classes(settings, shapes),
        .direction = settings.direction,
        .scale = distance_scale(settings),
        .seed = settings.seed,
        .relax = settings.relax,
        .kept = {},
        .window = {},
    };
    if (problem.torus)
        check_tile(settings, problem, shapes);
    return problem;
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

/// `fill_with_margin` is the share that the ellipses of half size cover, which do not overlap when
/// all elements point the same way. It is left out where they may overlap: of evenly mixed classes
/// of given sizes, which come nearer to each other than to elements of the same class, and where
/// the spacing varies.
Facts facts_of(const ElementsSettings& settings, const std::vector<ElementShape>& shapes,
               const PoissonDiskSet& set, const std::vector<std::uint32_t>& components) {
    double bare = 0, exclusive = 0;
    for (std::size_t i = 0; i < set.samples.size(); ++i) {
        const ElementShape& shape = shapes[components[i]];
        const double scale2 = set.samples[i].scale * set.samples[i].scale;
        bare += shape.area * scale2;
        exclusive += pi / 4 * shape.room.exclusive.length * shape.room.exclusive.width * scale2;
    }
    const double domain = area(*settings.domain);
    Facts facts{{"count", double(set.samples.size())}, {"fill", bare / domain}};
    const bool overlap_within =
        shapes.size() > 1 && settings.mix == ElementMix::even && shapes.front().sized;
    if (!overlap_within && settings.spacing == nullptr)
        facts.emplace_back("fill_with_margin", exclusive / domain);
    facts.emplace_back("trials", double(set.trials));
    facts.emplace_back("unresolved", double(set.unresolved));
    add_shares(components, shapes.size(), facts);
    return facts;
}

std::shared_ptr<const Picture> background_of(const ElementsSettings& settings) {
    if (settings.background.empty())
        return nullptr;
    return located(settings.background_place, [&] {
        Picture picture =
            read_picture(settings.background, drawing_pixels, settings.background_options);
        picture.box = bounds(*settings.domain);
        return std::make_shared<const Picture>(std::move(picture));
    });
}

/// What is known before anything is placed.
struct PreparedElements {
    explicit PreparedElements(const Params& params) : settings(elements_settings(params)) {
        const auto start = Clock::now();
        shapes = element_shapes(settings);
        if (settings.surface != nullptr)
            check_surface_settings(settings);
        else
            problem = problem_from(settings, shapes);
        background = background_of(settings);
        preparing = Clock::now() - start;
    }

    ElementsSettings settings;
    std::vector<ElementShape> shapes;
    std::optional<PoissonDiskProblem> problem; // none on a surface
    std::shared_ptr<const Picture> background; // may be null
    Seconds preparing{};
};

Aggregate bake_elements(const PreparedElements& prepared, const Context& context) {
    const auto start = Clock::now();
    const ElementsSettings& settings = prepared.settings;
    const std::vector<ElementShape>& shapes = prepared.shapes;
    if (!prepared.problem)
        return bake_on_surface(settings, shapes, context);
    const PoissonDiskProblem& problem = *prepared.problem;
    const auto sampling_start = Clock::now();
    PoissonDiskSet set =
        located(settings.components_place, [&] { return sample_poisson_disks(problem, context); });
    const Seconds sampling = Clock::now() - sampling_start;
    if (settings.spacing != nullptr)
        for (DiskSample& sample : set.samples)
            sample.scale = settings.scale ? settings.scale->at(sample.position) : 1;
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
    aggregate.domain = settings.domain;
    aggregate.background = prepared.background;
    aggregate.torus = problem.torus;
    aggregate.texture = true;
    aggregate.facts = facts_of(settings, shapes, set, components);
    aggregate.facts.emplace_back("sampling_seconds", sampling.count());
    const Seconds seconds = prepared.preparing + (Clock::now() - start);
    aggregate.facts.emplace_back("seconds", seconds.count());
    return aggregate;
}

} // namespace

Plugin<Generator> elements_plugin() {
    return {"elements",
            "Discrete element textures: components evenly spread over a region, by maximal "
            "Poisson-disk sampling (Kita & Miyata 2012).",
            elements_specs(), [](const Params& params) -> Bake {
                return [prepared = std::make_shared<const PreparedElements>(params)](
                           const Context& context) { return bake_elements(*prepared, context); };
            }};
}

} // namespace scree
