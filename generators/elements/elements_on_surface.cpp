// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/elements/elements_on_surface.h"

#include "core/located.h"
#include "core/parallel.h"
#include "core/random.h"
#include "generators/elements/element_kinds.h"
#include "geometry/sampling/surface_disks.h"

#include <chrono>

namespace scree {

namespace {

// The component's centre goes to the sample, its y axis along the normal, and its x axis, at angle
// 0, along the surface's level line.
Matrix standing(const ElementShape& shape, const Vec3& normal, const Imath::V3d& position,
                double angle) {
    Vec3 x = Vec3(0, 1, 0).cross(normal);
    x = x.length() > 1e-4F ? x.normalized() : Vec3(1, 0, 0);
    const Vec3 z = x.cross(normal);
    const auto cosine = static_cast<float>(std::cos(angle));
    const auto sine = static_cast<float>(std::sin(angle));
    const Vec3 u = x * cosine + z * sine;
    const Vec3 w = z * cosine - x * sine;
    const Vec3 origin = Vec3(position) + normal * static_cast<float>(shape.height) -
                        u * static_cast<float>(shape.centre.x) -
                        w * static_cast<float>(shape.centre.y);
    return {u.x, u.y, u.z, 0, normal.x, normal.y, normal.z, 0,
            w.x, w.y, w.z, 0, origin.x, origin.y, origin.z, 1};
}

} // namespace

void check_surface_settings(const ElementsSettings& settings) {
    const auto refuse = [](bool given, const ParamPlace& place) {
        if (given)
            throw place.error("lies on the ground, but the elements stand on a surface");
    };
    refuse(settings.direction != nullptr, settings.direction_place);
    refuse(settings.scale != nullptr, settings.scale_place);
    refuse(settings.spacing != nullptr, settings.spacing_place);
    refuse(!settings.background.empty(), settings.background_place);
    if (settings.torus)
        throw settings.torus_place.error("is set, but a surface does not tile");
    if (settings.relax > 0)
        throw settings.relax_place.error("is set, but elements on a surface do not move");
}

Aggregate bake_on_surface(const ElementsSettings& settings, const std::vector<ElementShape>& shapes,
                          const Context& context) {
    const auto start = std::chrono::steady_clock::now();
    const Mesh& mesh = *settings.surface;
    const std::vector<DiskClass> classes = disk_classes(settings, shapes);
    SurfaceDiskProblem problem{.mesh = &mesh, .distances = {}, .seed = settings.seed};
    for (const DiskClass& c : classes)
        problem.distances.push_back(c.length);
    const SurfaceDiskSet set =
        located(settings.surface_place, [&] { return sample_surface_disks(problem, context); });
    std::vector<std::uint32_t> sample_classes;
    for (const SurfaceSample& sample : set.samples)
        sample_classes.push_back(sample.disk_class);
    const std::vector<std::uint32_t> components =
        components_of(sample_classes, shapes, classes.size(), problem.seed);

    Aggregate aggregate;
    aggregate.generator = "elements";
    aggregate.seed = problem.seed;
    for (const ElementShape& shape : shapes)
        aggregate.prototypes.push_back(shape.prototype);
    aggregate.instances.resize(set.samples.size());
    parallel_for(set.samples.size(), 256, [&](std::size_t i) {
        const SurfaceSample& sample = set.samples[i];
        const ElementShape& shape = shapes[components[i]];
        const double angle =
            Random(problem.seed, Purpose::disk_class, i).uniform(shape.turn.low, shape.turn.high);
        aggregate.instances[i] = {
            .prototype = components[i],
            .world_from_object =
                WideMatrix(standing(shape, smooth_normal(mesh, sample), sample.position, angle)),
            .random = Random(problem.seed, Purpose::instance_attribute, i).uniform_float(),
            .angle = angle,
            .scale = 1};
    });
    double bare = 0;
    for (const std::uint32_t component : components)
        bare += shapes[component].area;
    aggregate.facts = {{"count", double(set.samples.size())},
                       {"fill", bare / area(mesh)},
                       {"trials", double(set.trials)},
                       {"unresolved", double(set.unresolved)}};
    add_shares(components, shapes.size(), aggregate.facts);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    aggregate.facts.emplace_back("seconds", seconds.count());
    return aggregate;
}

} // namespace scree
