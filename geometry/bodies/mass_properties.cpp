// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/mass_properties.h"

namespace scree {

namespace {

/// Integrals of 1, x and x x^T over simplices.
struct Moments {
    double mass = 0;
    Imath::V3d first{0.0, 0.0, 0.0};
    Imath::M33d second{0, 0, 0, 0, 0, 0, 0, 0, 0};

    /// Adds a simplex of the given volume or area: a triangle with these corners (`at_origin` 0),
    /// or a tetrahedron with them and the origin (1).
    void add(double size, const std::array<Imath::V3d, 3>& corners, int at_origin) {
        const double n = 3 + at_origin;
        const Imath::V3d sum = corners[0] + corners[1] + corners[2];
        mass += size;
        first += sum * (size / n);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                double products = sum[i] * sum[j];
                for (const Imath::V3d& corner : corners)
                    products += corner[i] * corner[j];
                second[i][j] += products * size / (n * (n + 1));
            }
    }
};

} // namespace

MassProperties mass_properties(const Body& body) {
    const Mesh& mesh = *body.mesh;
    const double thickness = 2 * body.skin;
    Moments moments;
    for (const Mesh::Triangle& t : mesh.triangles) {
        std::array<Imath::V3d, 3> v;
        for (std::size_t k = 0; k < 3; ++k)
            v[k] = Imath::V3d(mesh.positions[t[k]] - body.origin);
        if (thickness > 0)
            moments.add((v[1] - v[0]).cross(v[2] - v[0]).length() / 2 * thickness, v, 0);
        else
            moments.add(v[0].dot(v[1].cross(v[2])) / 6, v, 1);
    }
    if (moments.mass < 0) { // the triangles face inwards
        moments.mass = -moments.mass;
        moments.first = -moments.first;
        moments.second *= -1;
    }
    const Imath::V3d centre = moments.first / moments.mass;
    Imath::M33d inertia;
    double trace = 0;
    for (int i = 0; i < 3; ++i)
        trace += moments.second[i][i] - moments.mass * centre[i] * centre[i];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            inertia[i][j] = (i == j ? trace : 0.0) - moments.second[i][j] +
                            moments.mass * centre[i] * centre[j];
    // Scaled, since the determinant of a small body's inertia would be too small for a double.
    const double unit = trace;
    inertia /= unit;
    return {moments.mass, Vec3(centre), inertia.inverse() / unit};
}

} // namespace scree
