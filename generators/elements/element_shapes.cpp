// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/elements/element_shapes.h"

#include "core/located.h"
#include "generators/elements/class_sizes.h"
#include "geometry/plane/flat_mesh.h"
#include "geometry/plane/region_tools.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

Prototype prototype_of(const ElementComponent& component, std::size_t index) {
    Prototype prototype;
    if (component.picture) {
        prototype.shape = component.picture->mesh;
        prototype.region = component.picture->region;
        prototype.picture = component.picture->picture;
    } else if (component.mesh != nullptr) {
        prototype.shape = component.mesh;
        prototype.region =
            component.given_region != nullptr
                ? component.given_region
                : located(component.shape_place, [&] {
                      return std::make_shared<const Region>(silhouette(*component.mesh));
                  });
    } else {
        prototype.region = component.flat_shape;
        prototype.shape = std::make_shared<const Mesh>(
            flat_mesh(*component.flat_shape, fmt::format("component_{}", index)));
    }
    prototype.name = prototype.mesh()->name;
    prototype.materials = component.materials;
    return prototype;
}

/// How much directions of elements may differ, apart from where they lie.
double spread_of(const std::vector<ElementShape>& shapes) {
    Range all = shapes.front().turn;
    for (const ElementShape& shape : shapes)
        all = {std::min(all.low, shape.turn.low), std::max(all.high, shape.turn.high)};
    return all.high - all.low;
}

EllipseAxes grown(const EllipseAxes& axes, double by) {
    return {axes.length + by, axes.width + by};
}

/// The axes that the script gives. Where it gives one of them, the other follows in the proportions
/// of `derived`; a disk has the larger one.
EllipseAxes given_axes(const ElementComponent& component, const EllipseAxes& derived, bool disk) {
    const double aspect = derived.width / derived.length;
    EllipseAxes axes;
    axes.length = component.length ? *component.length : *component.width / aspect;
    axes.width = component.width ? *component.width : axes.length * aspect;
    if (disk)
        axes.length = axes.width = std::max(axes.length, axes.width);
    return axes;
}

/// What keeps others away.
const Region& outline_of(const ElementComponent& component, const Prototype& prototype) {
    return component.given_region != nullptr ? *component.given_region : *prototype.region;
}

void measure(const ElementComponent& component, bool disk, double spread, ElementShape& shape) {
    const Region& region = outline_of(component, shape.prototype);
    const double margin = component.margin;
    shape.reach = enclosing_disk(region).length + margin;
    EllipseAxes& half = shape.room.half;
    EllipseAxes& exclusive = shape.room.exclusive;
    half = grown(disk ? enclosing_disk(region) : enclosing_ellipse(region), margin);
    if (!(std::min(half.length, half.width) > 0))
        throw component.margin_place.error("leaves nothing of the element");
    exclusive = exclusive_ellipse(half, spread);
    shape.sized = component.length || component.width;
    if (shape.sized)
        exclusive = grown(given_axes(component, exclusive, disk), 2 * margin);
    if (!(std::min(exclusive.length, exclusive.width) > 0))
        throw component.margin_place.error("leaves nothing of the length and width given");
}

} // namespace

std::vector<ElementShape> element_shapes(const ElementsSettings& settings) {
    const std::vector<ElementComponent>& components = settings.components;
    std::vector<ElementShape> shapes(components.size());
    for (std::size_t i = 0; i < components.size(); ++i) {
        const ElementComponent& component = components[i];
        ElementShape& shape = shapes[i];
        shape.prototype = prototype_of(component, i);
        const Region& outline = outline_of(component, shape.prototype);
        shape.area = area(outline);
        if (!(shape.area > 0))
            throw component.region_place.error("the region has no area");
        shape.centre = bounds(outline).center();
        shape.weight = component.weight;
        shape.height = component.height;
        shape.turn = component.turn;
    }
    const double spread = spread_of(shapes);
    for (std::size_t i = 0; i < components.size(); ++i) {
        measure(components[i], settings.are_disks, spread, shapes[i]);
        if (settings.mix == ElementMix::even && shapes[i].sized != shapes[0].sized)
            throw components[i].length_place.error(
                shapes[i].sized ? "is given here, but no size for components[1]"
                                : "is missing, but components[1] has its size given",
                "evenly mixed components have their sizes given all or none");
    }
    return shapes;
}

std::vector<DiskClass> disk_classes(const ElementsSettings& settings,
                                    const std::vector<ElementShape>& shapes) {
    std::vector<DiskClass> classes;
    if (settings.mix == ElementMix::random) {
        DiskClass all{.turn = shapes.front().turn};
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (shapes[i].turn.low != all.turn.low || shapes[i].turn.high != all.turn.high)
                throw settings.components[i].rotation_place.error(
                    "differs from that of components[1]",
                    "components mixed at random all turn alike");
            all.length = std::max(all.length, shapes[i].room.exclusive.length);
            all.width = std::max(all.width, shapes[i].room.exclusive.width);
        }
        classes.push_back(all);
        return classes;
    }
    for (const ElementShape& shape : shapes)
        classes.push_back({shape.room.exclusive.length, shape.room.exclusive.width, shape.turn});
    if (shapes.size() == 1 || shapes.front().sized)
        return classes;
    const double spread = spread_of(shapes);
    const std::size_t count = shapes.size();
    std::vector<double> least(count * count), weights;
    for (std::size_t i = 0; i < count; ++i) {
        weights.push_back(shapes[i].weight);
        least[i * count + i] = shapes[i].room.exclusive.mean();
        for (std::size_t j = 0; j < i; ++j)
            least[i * count + j] = least[j * count + i] =
                class_distance(shapes[i].room, shapes[j].room, spread);
    }
    const std::vector<double> sizes = class_sizes(least, weights);
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const double factor = sizes[i] / shapes[i].room.exclusive.mean();
        classes[i].length *= factor;
        classes[i].width *= factor;
    }
    return classes;
}

} // namespace scree
