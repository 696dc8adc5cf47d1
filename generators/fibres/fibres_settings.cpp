// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/fibres_settings.h"

#include "core/physical_memory.h"
#include "geometry/mesh/not_closed.h"
#include "geometry/mesh/side_normals.h"
#include "model/file_material.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree::fibres {

namespace {

constexpr double much_fill = 0.2; // loose fibres are hardly ever denser

// About what is held for a vertex at the peak of the work, by counting arrays.
constexpr double bytes_of_vertex = 30;
constexpr double bytes_of_vertex_in_contact = 200;

/// The mesh of a parameter, moved to the position that another gives; null without one.
std::shared_ptr<const Mesh> placed_mesh(const Params& params, const char* name, const char* place) {
    auto mesh = params.object<Mesh>(name);
    const Vec3& position = params.vector3(place);
    if (!mesh || position == Vec3(0.0F))
        return mesh;
    Mesh moved = *mesh;
    transform(moved, Matrix().setTranslation(position));
    return std::make_shared<const Mesh>(std::move(moved));
}

double longest_side(const Mesh& mesh) {
    const Vec3 size = bounds(mesh).size();
    return std::max({size.x, size.y, size.z});
}

void check_target(const Params& params, const FibresSettings& settings) {
    if (settings.target && settings.roots)
        throw params.error("target", "is given beside roots; one of them will do");
    if (settings.roots) {
        if (settings.roots->triangles.empty() || !(area(*settings.roots) > 0))
            throw params.error("roots", "the mesh has no surface");
        return;
    }
    if (!settings.target)
        throw params.error("target", "is missing", "expected a closed mesh, or roots");
    if (settings.target->triangles.empty())
        throw params.error("target", "the mesh is empty");
    const MeshFacts facts = inspect(*settings.target);
    if (!facts.closed())
        throw params.error("target", not_closed(facts), "expected a closed mesh");
}

void read_shape(const Params& params, FibresSettings& settings) {
    FibreShape& shape = settings.shape;
    const double size = longest_side(settings.target ? *settings.target : *settings.roots);
    const double usual = settings.target ? size / 2 : size / 5;
    shape.length = params.has("length") ? params.range("length") : Range{usual, usual};
    shape.radius = params.has("radius") ? params.number("radius") : shape.length.high / 250;
    shape.segments = static_cast<std::uint32_t>(params.integer("segments"));
    shape.taper = params.number("taper");
    shape.theta = params.range("theta");
    shape.phi = params.range("phi");
    if (!(shape.radius < shape.length.low / 8))
        throw params.error("radius", fmt::format("{:g} is not below an eighth of the length, {:g}",
                                                 shape.radius, shape.length.low / 8));
    if (shape.length.low / shape.segments < 2 * shape.radius)
        throw params.error(
            "segments",
            fmt::format("a segment would be shorter than a fibre is thick, {:g} m",
                        2 * shape.radius),
            fmt::format("at most {:g}, or thinner fibres",
                        std::max(1.0, std::floor(shape.length.low / (2 * shape.radius)))));
    if (settings.target && shape.length.high > size)
        params.warn(params.has("length") ? "length" : "target",
                    fmt::format("fibres of {:g} m are longer than the target, {:g} m",
                                shape.length.high, size));
}

void read_flow(const Params& params, FibresSettings& settings) {
    if (!params.has("flow")) {
        if (params.has("flow_rise"))
            throw params.error("flow_rise", "is given without a flow", "expected flow beside it");
        return;
    }
    settings.flow = FibreFlow{.heading = field_of(params, "flow"),
                              .rise = field_of(params, "flow_rise"),
                              .strength = params.number("flow_strength")};
}

/// Whether all of a sample of a mesh's vertices lie inside of a closed mesh.
bool holds(const Mesh& outer, const Mesh& inner) {
    constexpr std::size_t most = 256; // a winding number asks every triangle
    const std::size_t step = std::max<std::size_t>(1, inner.positions.size() / most);
    for (std::size_t i = 0; i < inner.positions.size(); i += step)
        if (std::abs(winding_number(outer, Imath::V3d(inner.positions[i]))) < 0.5)
            return false;
    return true;
}

/// Refuses a solid around all of the target. Where the solid's surface goes on inside of the
/// target, there may be a hollow for the fibres.
void check_container(const Params& params, const FibresSettings& settings) {
    if (!settings.container)
        return;
    const Mesh& container = *settings.container;
    if (container.triangles.empty())
        throw params.error("container", "the mesh is empty");
    if (!settings.contact || !settings.target || !inspect(container).closed() ||
        !holds(container, *settings.target))
        return;
    const Box3 box = bounds(*settings.target);
    const bool hollow =
        std::ranges::any_of(container.positions, [&](const Vec3& p) { return box.intersects(p); });
    if (!hollow)
        throw params.error("container",
                           "is a solid with all of the target inside, where fibres have no room",
                           "expected a vessel around the target, such as a bowl or an open mesh");
}

void read_contact(const Params& params, FibresSettings& settings) {
    settings.contact = params.flag("contact");
    settings.gravity = params.flag("gravity");
    settings.contact_settings = {.radius = settings.shape.radius,
                                 .tolerance = params.number("tolerance"),
                                 .stiffness = params.number("stiffness"),
                                 .friction = params.number("friction"),
                                 .max_iterations =
                                     static_cast<int>(params.integer("max_iterations"))};
    settings.container = placed_mesh(params, "container", "container_position");
    check_container(params, settings);
    if (params.has("floor"))
        settings.floor = params.number("floor");
    if (settings.floor && settings.target) {
        const Box3 box = bounds(*settings.target);
        if (*settings.floor > double(box.max.y) - 2 * settings.shape.radius)
            throw params.error("floor",
                               fmt::format("{:g} is above the target, which ends at {:.4g}",
                                           *settings.floor, double(box.max.y)));
    }
    if (settings.gravity && !settings.floor && !settings.container)
        throw params.error("gravity", "is given, but nothing to fall on",
                           "expected floor or container beside it");
    if (settings.gravity && !settings.contact)
        throw params.error("gravity", "is given without contact", "expected contact = true");
}

void check_memory(const Params& params, const FibresSettings& settings) {
    const double vertices = double(settings.count) * settings.shape.vertices();
    const double bytes =
        vertices * (settings.contact ? bytes_of_vertex_in_contact : bytes_of_vertex);
    if (bytes > physical_memory())
        throw Error(Fault::resource,
                    params
                        .error("count",
                               fmt::format("{} fibres of {} segments need about {:.0f} GiB of "
                                           "memory, more than there is",
                                           settings.count, settings.shape.segments,
                                           bytes / double(1 << 30)),
                               "expected fewer, or contact = false")
                        .diagnostics());
}

} // namespace

double FibresSettings::fill() const {
    if (!target)
        return 0;
    // Of a cone's frustum, by the mean of its radii squared.
    const double area =
        pi * shape.radius * shape.radius * (1 + shape.taper + shape.taper * shape.taper) / 3;
    const double length = (shape.length.low + shape.length.high) / 2;
    return double(count) * area * length / std::abs(volume(*target));
}

FibresSettings fibres_settings(const Params& params) {
    FibresSettings settings;
    settings.target = placed_mesh(params, "target", "position");
    settings.target_place = params.place("target");
    settings.roots = placed_mesh(params, "roots", "position");
    check_target(params, settings);
    settings.count = static_cast<std::size_t>(params.integer("count"));
    read_shape(params, settings);
    read_flow(params, settings);
    const std::string& adjustment = params.text("adjustment");
    settings.adjustment = adjustment == "none"     ? Adjustment::none
                          : adjustment == "thesis" ? Adjustment::thesis
                                                   : Adjustment::nearest;
    read_contact(params, settings);
    check_memory(params, settings);
    settings.spline = params.text("curve") == "bspline";
    settings.materials = materials_of(params, nullptr);
    settings.seed = static_cast<std::uint64_t>(params.integer("seed"));
    settings.warn = [params](const std::string& message) { params.warn("contact", message); };
    if (settings.fill() > much_fill)
        params.warn("count", fmt::format("fibres would fill {:.0f}% of the target, of which more "
                                         "than {:.0f}% is hard to reach without overlap",
                                         100 * settings.fill(), 100 * much_fill));
    return settings;
}

} // namespace scree::fibres
