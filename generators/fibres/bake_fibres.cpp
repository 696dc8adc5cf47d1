// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/bake_fibres.h"

#include "core/parallel.h"
#include "generators/fibres/contact.h"
#include "generators/fibres/fibre_order.h"
#include "generators/fibres/fibre_source.h"
#include "generators/fibres/rest.h"
#include "geometry/mesh/strand_spline.h"
#include "model/stage_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace scree::fibres {

namespace {

using Placed = FibreSource::Placed;

/// Where fibres begin: in a target or on roots.
struct Places {
    std::shared_ptr<const SignedDistanceGrid> target;
    std::optional<Interior> interior;
    std::optional<Roots> roots;
};

Places places_of(const FibresSettings& settings, const Context& context) {
    Places places;
    if (settings.roots) {
        places.roots = roots_on(*settings.roots, settings.count, settings.seed, context);
        return places;
    }
    places.target =
        std::make_shared<const SignedDistanceGrid>(boundary_grid(*settings.target, false));
    places.interior.emplace(*places.target, settings.shape.radius);
    if (places.interior->empty())
        throw settings.target_place.error(
            "no point of the target is deeper inside than the radius of a fibre",
            "expected a thicker target, or thinner fibres");
    return places;
}

/// How many vertices are outside of the shape.
double outside_of(const SignedDistanceGrid& shape, const RigidFibres& fibres) {
    std::atomic<std::size_t> outside = 0;
    parallel_for(fibres.poses.size(), 64, [&](std::size_t i) {
        const Pose& pose = fibres.poses[i];
        const std::span<const Vec3> local(&fibres.local[i * fibres.vertices], fibres.vertices);
        outside += std::size_t(std::ranges::count_if(local, [&](const Vec3& p) {
            return shape.at(pose.centre + rotated(pose.rotation, p)) > 0;
        }));
    });
    return double(outside);
}

int adjust(RigidFibres& fibres, const FibresSettings& settings, const FibreSource& source,
           const SignedDistanceGrid& target, const Context& context) {
    if (settings.adjustment == Adjustment::nearest)
        return adjust_nearest(fibres, target, settings.shape.radius, context);
    std::vector<float> lengths(settings.count);
    for (std::size_t i = 0; i < lengths.size(); ++i)
        lengths[i] = source.segment_length(i) * static_cast<float>(settings.shape.segments);
    const NearestVertices vertices(*settings.target, settings.shape.length.high / 2);
    return adjust_thesis(fibres, vertices, lengths, context);
}

/// Takes each fibre from its own frame to the scene.
void to_scene(Placed& placed) {
    RigidFibres& fibres = placed.rigid;
    parallel_for(fibres.poses.size(), 64, [&](std::size_t i) {
        const Pose& pose = fibres.poses[i];
        for (Vec3& p : std::span(&fibres.local[i * fibres.vertices], fibres.vertices))
            p = pose.centre + rotated(pose.rotation, p);
        placed.normals[i] = rotated(pose.rotation, placed.normals[i]);
    });
}

/// An order in which neighbours lie near each other in memory.
std::vector<std::uint32_t> order_of(const RigidFibres& fibres) {
    std::vector<Vec3> places(fibres.poses.size());
    std::ranges::transform(fibres.poses, places.begin(), &Pose::centre);
    return order_in_space(places);
}

/// The fibres as rods in this order, from where they are in the scene; takes their vertices.
Rods rods_of(Placed& placed, const FibresSettings& settings, const FibreSource& source,
             std::span<const std::uint32_t> order) {
    const std::uint32_t n = settings.shape.segments;
    Rods rods{.segments = n, .rooted = settings.roots != nullptr};
    rods.points.resize(placed.rigid.local.size());
    rods.frames.resize(settings.count * n);
    rods.rest.resize(settings.count * (n - 1));
    rods.lengths.resize(settings.count);
    for (std::uint32_t v = 0; v <= n; ++v)
        rods.radii.push_back(settings.shape.radius_at(v));
    parallel_for(settings.count, 64, [&](std::size_t i) {
        std::vector<Vec3> points(n + 1);
        const std::span<Rotation> frames(&rods.frames[i * n], n);
        const std::size_t fibre = order[i];
        source.grow(fibre, points, frames);
        std::copy_n(&placed.rigid.local[fibre * (n + 1)], n + 1, &rods.points[i * (n + 1)]);
        rods.lengths[i] = source.segment_length(fibre);
        for (Rotation& frame : frames)
            frame = unit(placed.rigid.poses[fibre].rotation * frame);
    });
    placed.rigid.local.clear();
    placed.rigid.local.shrink_to_fit();
    take_shapes_as_rest(rods);
    return rods;
}

/// What bounds fibres beside the target.
Boundary boundary_of(const FibresSettings& settings) {
    Boundary boundary;
    if (settings.roots)
        boundary.stay_outside(settings.roots);
    if (settings.container)
        boundary.stay_outside(settings.container);
    if (settings.floor)
        boundary.stay_above(*settings.floor);
    return boundary;
}

void bend_apart(Placed& placed, const FibresSettings& settings, const Places& places,
                const FibreSource& source, const Context& context, Facts& facts) {
    const std::vector<std::uint32_t> order = order_of(placed.rigid);
    Rods rods = rods_of(placed, settings, source, order);
    const Boundary held = boundary_of(settings);
    Boundary boundary = held;
    if (settings.target)
        boundary.stay_inside(settings.target, places.target);
    const double radius = settings.shape.radius;
    ContactResult result = resolve_contact(rods, boundary, settings.contact_settings, context);
    if (settings.gravity) {
        // Contact bent them for good: fibres that sprang back would press into each other harder
        // than their weight does.
        take_shapes_as_rest(rods);
        const RestResult rest = come_to_rest(rods, held, settings.contact_settings, context);
        facts.insert(facts.end(), {{"rest_steps", double(rest.steps)},
                                   {"rest_passes", double(rest.passes)},
                                   {"mean_step", rest.mean_step}});
        if (!rest.at_rest)
            settings.warn(fmt::format("fibres are not at rest after {} steps: they still move by "
                                      "{:.3g} radii in each",
                                      rest.steps, rest.mean_step));
        take_shapes_as_rest(rods);
        result = resolve_contact(rods, held, settings.contact_settings, context);
    }
    const ContactMeasure& measure = result.measure;
    facts.insert(facts.end(), {{"contact_iterations", double(result.iterations)},
                               {"neighbour_searches", double(result.searches)},
                               {"overlaps", double(measure.overlaps)},
                               {"deepest", double(measure.deepest) / radius},
                               {"outside", double(measure.outside) / radius},
                               {"length_error", length_error(rods)}});
    const double tolerance = settings.contact_settings.tolerance;
    if (!measure.within(static_cast<float>(tolerance * radius)))
        settings.warn(fmt::format(
            "fibres are up to {:.3g} radii deep in each other and {:.3g} outside after {} "
            "iterations, more than the tolerance of {:g}",
            double(measure.deepest) / radius, double(measure.outside) / radius, result.iterations,
            tolerance));
    const std::size_t n = rods.vertices();
    placed.rigid.local.resize(rods.points.size());
    for (std::size_t i = 0; i < settings.count; ++i) {
        placed.normals[order[i]] = rotated(rods.frames[i * rods.segments], Vec3(1, 0, 0));
        std::copy_n(&rods.points[i * n], n, &placed.rigid.local[order[i] * n]);
    }
}

std::shared_ptr<Strands> strands_of(Placed&& placed, const FibresSettings& settings) {
    auto strands = std::make_shared<Strands>();
    const std::uint32_t vertices = settings.shape.vertices();
    strands->name = "fibres";
    strands->points = std::move(placed.rigid.local);
    strands->normals = std::move(placed.normals);
    strands->radii.resize(strands->points.size());
    strands->randoms.resize(settings.count);
    strands->offsets.resize(settings.count + 1);
    parallel_for(settings.count, 256, [&](std::size_t i) {
        strands->offsets[i + 1] = static_cast<std::uint32_t>((i + 1) * vertices);
        strands->randoms[i] = Random(settings.seed, Purpose::fibre_attribute, i).uniform_float();
        for (std::uint32_t v = 0; v < vertices; ++v)
            strands->radii[i * vertices + v] = settings.shape.radius_at(v);
    });
    return strands;
}

} // namespace

Aggregate bake_fibres(const FibresSettings& settings, const Context& context) {
    StageTimes stages;
    Aggregate aggregate;
    aggregate.generator = "fibres";
    aggregate.seed = settings.seed;
    Facts& facts = aggregate.facts;
    facts = {{"count", double(settings.count)},
             {"vertices", double(settings.count * settings.shape.vertices())}};
    const Places places = places_of(settings, context);
    if (places.target)
        facts.emplace_back("fill", settings.fill());
    else
        facts.emplace_back("root_spacing", places.roots->spacing / settings.shape.radius);
    stages.end("preparing");
    context.report("growing", 0);
    const FibreSource source(settings, places.interior ? &*places.interior : nullptr,
                             places.roots ? &*places.roots : nullptr);
    Placed placed = source.place_all();
    stages.end("growing");
    if (places.target) {
        facts.emplace_back("outside_placed", outside_of(*places.target, placed.rigid));
        stages.end("counting");
        if (settings.adjustment != Adjustment::none)
            facts.emplace_back("adjusting_iterations",
                               adjust(placed.rigid, settings, source, *places.target, context));
        stages.end("adjusting");
        facts.emplace_back("outside_adjusted", outside_of(*places.target, placed.rigid));
    }
    to_scene(placed);
    stages.end("placing");
    if (settings.contact) {
        bend_apart(placed, settings, places, source, context, facts);
        stages.end("contact");
    }
    std::shared_ptr<Strands> strands = strands_of(std::move(placed), settings);
    if (settings.spline) {
        const auto splines = std::make_shared<Strands>(splined(*strands));
        facts.emplace_back("curve_excess", spline_deviation(*strands, *splines));
        strands = splines;
    }
    aggregate.prototypes.push_back({.name = "fibres",
                                    .shape = std::shared_ptr<const Strands>(strands),
                                    .materials = settings.materials});
    aggregate.instances.emplace_back();
    stages.end("strands");
    stages.add_to(facts);
    return aggregate;
}

} // namespace scree::fibres
