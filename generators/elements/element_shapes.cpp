// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/elements/element_shapes.h"

#include "core/located.h"
#include "generators/elements/class_sizes.h"
#include "geometry/plane/flat_mesh.h"
#include "geometry/plane/picture_shape.h"
#include "geometry/plane/region_tools.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

void read_mesh(const Params& component, Prototype& prototype) {
    prototype.shape = component.object<Mesh>("shape");
    if (!component.has("region"))
        prototype.region = located(component, "shape", [&] {
            return std::make_shared<const Region>(silhouette(*prototype.mesh()));
        });
}

void read_picture(const Params& component, Prototype& prototype) {
    PictureShape shape = picture_shape(component);
    prototype.shape = std::move(shape.mesh);
    prototype.region = std::move(shape.region);
    prototype.picture = std::move(shape.picture);
}

Prototype read_prototype(const Params& component, std::size_t index) {
    const bool has_shape = component.has("shape");
    if (has_shape == component.has("picture"))
        throw component.error("shape",
                              has_shape ? "is given beside a picture; one of them will do"
                                        : "is missing, and there is no picture either",
                              has_shape ? ""
                                        : "expected a mesh.* or region.*, or picture = a path");
    Prototype prototype;
    if (!has_shape) {
        read_picture(component, prototype);
    } else if (component.object<Mesh>("shape") != nullptr) {
        read_mesh(component, prototype);
    } else {
        prototype.region = component.object<Region>("shape");
        prototype.shape = std::make_shared<const Mesh>(
            flat_mesh(*prototype.region, fmt::format("component_{}", index)));
    }
    if (prototype.region == nullptr)
        prototype.region = component.object<Region>("region");
    prototype.name = prototype.mesh()->name;
    prototype.material = component.object<Material>("material");
    return prototype;
}

Range turn_of(const Params& params, const Params& component) {
    if (component.has("rotation"))
        return component.range("rotation");
    if (params.has("rotation"))
        return params.range("rotation");
    return params.has("surface") ? Range{0, 2 * pi} : Range{0, 0};
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

/// What is given, the other axis in the shape's proportions; the larger one for disks.
EllipseAxes given_axes(const Params& component, const EllipseAxes& own, bool disk) {
    const double aspect = own.width / own.length;
    EllipseAxes axes;
    axes.length =
        component.has("length") ? component.number("length") : component.number("width") / aspect;
    axes.width = component.has("width") ? component.number("width") : axes.length * aspect;
    if (disk)
        axes.length = axes.width = std::max(axes.length, axes.width);
    return axes;
}

/// What keeps others away.
const Region& outline_of(const Params& component, const Prototype& prototype) {
    return component.has("region") ? *component.object<Region>("region") : *prototype.region;
}

void measure(const Params& component, bool disk, double spread, ElementShape& shape) {
    const Region& region = outline_of(component, shape.prototype);
    const double margin = component.number("margin");
    shape.reach = enclosing_disk(region).length + margin;
    EllipseAxes& half = shape.room.half;
    EllipseAxes& exclusive = shape.room.exclusive;
    half = grown(disk ? enclosing_disk(region) : enclosing_ellipse(region), margin);
    if (!(std::min(half.length, half.width) > 0))
        throw component.error("margin", "leaves nothing of the element");
    exclusive = exclusive_ellipse(half, spread);
    shape.sized = component.has("length") || component.has("width");
    if (shape.sized)
        exclusive = grown(given_axes(component, exclusive, disk), 2 * margin);
    if (!(std::min(exclusive.length, exclusive.width) > 0))
        throw component.error("margin", "leaves nothing of the length and width given");
}

} // namespace

std::vector<ElementShape> element_shapes(const Params& params) {
    const std::vector<Params>& components = params.list("components");
    std::vector<ElementShape> shapes(components.size());
    for (std::size_t i = 0; i < components.size(); ++i) {
        const Params& component = components[i];
        ElementShape& shape = shapes[i];
        shape.prototype = read_prototype(component, i);
        const Region& outline = outline_of(component, shape.prototype);
        shape.area = area(outline);
        if (!(shape.area > 0))
            throw component.error(component.has("region") ? "region" : "shape",
                                  "the region has no area");
        shape.centre = bounds(outline).center();
        shape.weight = component.number("weight");
        shape.height = component.number("height");
        shape.turn = turn_of(params, component);
    }
    const double spread = spread_of(shapes);
    const bool disk = params.text("exclusion") == "disk" || params.has("surface");
    for (std::size_t i = 0; i < components.size(); ++i) {
        measure(components[i], disk, spread, shapes[i]);
        if (params.text("mix") == "even" && shapes[i].sized != shapes[0].sized)
            throw components[i].error("length",
                                      shapes[i].sized
                                          ? "is given here, but no size for components[1]"
                                          : "is missing, but components[1] has its size given",
                                      "evenly mixed components have their sizes given all or none");
    }
    return shapes;
}

std::vector<DiskClass> disk_classes(const Params& params, const std::vector<ElementShape>& shapes) {
    std::vector<DiskClass> classes;
    if (params.text("mix") == "random") {
        DiskClass all{.turn = shapes.front().turn};
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (shapes[i].turn.low != all.turn.low || shapes[i].turn.high != all.turn.high)
                throw params.list("components")[i].error(
                    "rotation", "differs from that of components[1]",
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
