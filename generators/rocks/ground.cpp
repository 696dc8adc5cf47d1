// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/ground.h"

#include <algorithm>
#include <limits>

namespace scree::rocks {

namespace {

/// The height of the triangle over (x, z); `otherwise` where it is not.
double height_over(const Vec3& a, const Vec3& b, const Vec3& c, double x, double z,
                   double otherwise) {
    const double area =
        double(b.x - a.x) * double(c.z - a.z) - double(b.z - a.z) * double(c.x - a.x);
    if (area == 0)
        return otherwise;
    const double u =
        ((x - double(a.x)) * double(c.z - a.z) - (z - double(a.z)) * double(c.x - a.x)) / area;
    const double v =
        (double(b.x - a.x) * (z - double(a.z)) - double(b.z - a.z) * (x - double(a.x))) / area;
    if (u < -1e-6 || v < -1e-6 || u + v > 1 + 1e-6)
        return otherwise;
    return double(a.y) + u * double(b.y - a.y) + v * double(c.y - a.y);
}

} // namespace

Ground::Ground(const Mesh& mesh) : mesh_(std::in_place, mesh.positions, mesh.triangles) {}

double Ground::height(const Vec2& place) const {
    if (!mesh_)
        return -rise_ * place.y;
    double height = std::numeric_limits<float>::lowest();
    const Vec2f at(place);
    mesh_->each_in({at, at}, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        height = std::max(height, height_over(a, b, c, place.x, place.y, height));
    });
    return height;
}

} // namespace scree::rocks
