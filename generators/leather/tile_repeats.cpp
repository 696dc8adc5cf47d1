// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/tile_repeats.h"

#include "geometry/mesh/uv_jacobian.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

constexpr double notable_share = 0.05; // of the area: less, such as poles, is let pass

bool has_area(const UvJacobian& face) { return std::abs(face.turn) > 1e-12; }

// The larger of the larger singular value of the 3 x 2 matrix (u, v) and the inverse of the
// smaller.
double stretch_of(const Imath::V3d& u, const Imath::V3d& v) {
    const double mean = (u.length2() + v.length2()) / 2;
    const double spread = std::hypot((u.length2() - v.length2()) / 2, u.dot(v));
    const double larger = std::sqrt(mean + spread);
    const double smaller = u.cross(v).length() / larger; // their product is the area's factor
    return std::max(larger, 1 / smaller);
}

// How long one unit of u and of v is on the mesh, in the mean; 0 where no UVs have an area.
Vec2 unit_length(const Mesh& mesh) {
    Vec2 length(0.0, 0.0);
    double sum = 0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const UvJacobian face(mesh, t);
        const double weight = face.cross.length();
        if (!has_area(face) || !(weight > 0))
            continue; // a pole, where u means nothing
        length += Vec2(face.along_u.length(), face.along_v.length()) * weight;
        sum += weight;
    }
    return sum > 0 ? length / sum : length;
}

} // namespace

Vec2 tile_repeats(const Mesh& mesh, const Vec2& size) {
    const Vec2 length = unit_length(mesh);
    if (!(length.x > 0 && length.y > 0))
        return {1.0, 1.0};
    return {std::max(1.0, std::round(length.x / size.x)),
            std::max(1.0, std::round(length.y / size.y))};
}

Vec2 laid_size(const Mesh& mesh, const Vec2& size) {
    const Vec2 length = unit_length(mesh);
    return length.x > 0 && length.y > 0 ? length / tile_repeats(mesh, size) : size;
}

double tile_stretch(const Mesh& mesh, const Vec2& size) {
    const Vec2 tile = tile_repeats(mesh, size) * size; // of one unit of u and v
    std::vector<std::pair<double, double>> stretches;  // and the area that has it
    stretches.reserve(mesh.triangles.size());
    double area = 0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const UvJacobian face(mesh, t);
        const double weight = face.cross.length();
        if (!(weight > 0))
            continue;
        stretches.emplace_back(has_area(face)
                                   ? stretch_of(face.along_u / tile.x, face.along_v / tile.y)
                                   : std::numeric_limits<double>::infinity(),
                               weight);
        area += weight;
    }
    std::ranges::sort(stretches, std::greater());
    double seen = 0;
    for (const auto& [stretch, weight] : stretches) {
        seen += weight;
        if (seen >= notable_share * area)
            return stretch;
    }
    return 1;
}

} // namespace scree
