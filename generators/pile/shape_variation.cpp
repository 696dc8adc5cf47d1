// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/shape_variation.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

// The least share of its length that the inner side of a bend may keep: below it creases show.
constexpr double least_left = 0.2;

/// The right-handed frame of a deformation: along its axis, aside, and at right angles to both.
struct Axes {
    explicit Axes(const Deformation& d)
        : along(d.along), aside(d.aside), across(along.cross(aside)) {}

    Vec3d to(const Vec3d& v) const { return {v.dot(along), v.dot(aside), v.dot(across)}; }
    Vec3d from(const Vec3d& v) const { return along * v.x + aside * v.y + across * v.z; }

    Vec3d along, aside, across;
};

Vec3d turned_about_x(const Vec3d& v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {v.x, c * v.y - s * v.z, s * v.y + c * v.z};
}

Vec3d turned_about_z(const Vec3d& v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

Vec3d stretched(const Vec3d& v, double by) {
    const double across = 1 / std::sqrt(by);
    return {v.x * by, v.y * across, v.z * across};
}

double longest_side(const Box3& box, int& axis) {
    const Vec3 size = box.size();
    axis = 0;
    for (int k = 1; k < 3; ++k)
        if (size[k] > size[axis])
            axis = k;
    return double(size[axis]);
}

} // namespace

Vec3 Deformation::point(const Vec3& p) const {
    const Axes axes(*this);
    Vec3d v = stretched(axes.to(Vec3d(p) - Vec3d(centre)), stretch);
    const double half_way = v.x / (length * stretch); // -1/2 to 1/2
    v = turned_about_x(v, twist * half_way);
    const double curvature = bend / (length * stretch);
    const double angle = curvature * v.x;
    if (std::abs(bend) > 1e-6) {
        const double half = std::sin(angle / 2);
        const Vec3d on_axis(std::sin(angle) / curvature, 2 * half * half / curvature, 0);
        v = on_axis + turned_about_z({0, v.y, v.z}, angle);
    }
    return Vec3(Vec3d(centre) + axes.from(v) * scale);
}

Vec3 Deformation::normal(const Vec3& p, const Vec3& n) const {
    const Axes axes(*this);
    const Vec3d v = stretched(axes.to(Vec3d(p) - Vec3d(centre)), stretch);
    const double rate = twist / (length * stretch);
    const Vec3d at = turned_about_x(v, rate * v.x);
    Vec3d m = stretched(axes.to(Vec3d(n)), 1 / stretch);
    m = turned_about_x(m, rate * v.x);
    m.x -= rate * (m.z * at.y - m.y * at.z);
    if (std::abs(bend) > 1e-6) {
        const double curvature = bend / (length * stretch);
        m.x /= 1 - curvature * at.y;
        m = turned_about_z(m, curvature * at.x);
    }
    return Vec3(axes.from(m).normalized());
}

void check_bend(const Mesh& mesh, const ShapeVariation& variation) {
    const Box3 box = bounds(mesh);
    int axis = 0;
    const double length = longest_side(box, axis);
    double widest = 0;
    for (const Vec3& p : mesh.positions) {
        Vec3d v = Vec3d(p) - Vec3d(box.center());
        v[axis] = 0;
        widest = std::max(widest, v.length());
    }
    const double shortest = 1 - variation.stretch;
    const double most = (1 - least_left) * length * shortest * std::sqrt(shortest) / widest;
    if (variation.bend > most)
        throw Error({.where = {},
                     .path = {},
                     .message = "the component is too wide for such a bend: it would fold over",
                     .hint = fmt::format("expected at most {:.0f} degrees", degrees(most))});
}

Mesh varied_shape(const Mesh& mesh, const ShapeVariation& variation, std::uint32_t index,
                  Random random) {
    const Box3 box = bounds(mesh);
    int axis = 0;
    Deformation d;
    d.centre = box.center();
    d.length = longest_side(box, axis);
    if (!(d.length > 0))
        return mesh; // a single point
    check_bend(mesh, variation);

    const auto either_way = [&](double most) { return random.uniform(-most, most); };
    const double direction = random.uniform(0, 2 * pi);
    d.along = d.aside = Vec3(0);
    d.along[axis] = 1;
    d.aside[(axis + 1) % 3] = static_cast<float>(std::cos(direction));
    d.aside[(axis + 2) % 3] = static_cast<float>(std::sin(direction));
    d.bend = either_way(variation.bend);
    d.twist = either_way(variation.twist);
    d.stretch = 1 + either_way(variation.stretch);
    const double share = (double(index) + random.uniform()) / double(variation.shapes);
    d.scale = variation.scale.low + (variation.scale.high - variation.scale.low) * share;

    Mesh out = mesh;
    for (std::size_t i = 0; i < out.positions.size(); ++i)
        out.positions[i] = d.point(mesh.positions[i]);
    for (std::size_t i = 0; i < out.normals.size(); ++i)
        out.normals[i] = d.normal(mesh.positions[i], mesh.normals[i]);
    return out;
}

} // namespace scree
