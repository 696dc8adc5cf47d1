// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/rock/geodesic_sphere.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <mutex>

namespace scree {

namespace {

/// The vertices and faces of an icosahedron; faces turn counter-clockwise seen from outside.
struct Icosahedron {
    std::array<WideVec3, 12> vertices;
    std::vector<std::array<std::uint32_t, 3>> faces;
};

Icosahedron icosahedron() {
    Icosahedron solid;
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::size_t count = 0;
    for (const double one : {-1.0, 1.0})
        for (const double far : {-golden, golden}) {
            solid.vertices[count++] = WideVec3(0, one, far).normalized();
            solid.vertices[count++] = WideVec3(one, far, 0).normalized();
            solid.vertices[count++] = WideVec3(far, 0, one).normalized();
        }
    const auto adjacent = [&](std::uint32_t a, std::uint32_t b) {
        return (solid.vertices[a] ^ solid.vertices[b]) > 0.4; // 1 / sqrt(5), else negative
    };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c)
                if (adjacent(a, b) && adjacent(b, c) && adjacent(a, c)) {
                    const WideVec3& p = solid.vertices[a];
                    const bool outwards =
                        ((solid.vertices[b] - p).cross(solid.vertices[c] - p) ^ p) > 0;
                    solid.faces.push_back(outwards ? std::array{a, b, c} : std::array{a, c, b});
                }
    return solid;
}

WideVec3 slerp(const WideVec3& a, const WideVec3& b, double t) {
    const double angle = std::acos(std::clamp(a ^ b, -1.0, 1.0));
    return angle < 1e-9
               ? a
               : (a * std::sin((1 - t) * angle) + b * std::sin(t * angle)) / std::sin(angle);
}

/// Fills directions and triangles. A direction is named by the icosahedron's vertices that it lies
/// between, each with its number of steps of n, so that faces share those of their edges.
class Division {
  public:
    Division(GeodesicSphere& sphere, int n) : sphere_(sphere), n_(n) {}

    void run() {
        for (const auto& face : solid_.faces)
            divide(face);
    }

  private:
    using Name = std::array<std::pair<std::uint32_t, int>, 3>;

    void divide(const std::array<std::uint32_t, 3>& face) {
        for (int row = 0; row < n_; ++row)
            for (int i = 0; i <= row; ++i) {
                sphere_.triangles.push_back(
                    {at(face, row, i), at(face, row + 1, i), at(face, row + 1, i + 1)});
                if (i < row)
                    sphere_.triangles.push_back(
                        {at(face, row, i), at(face, row + 1, i + 1), at(face, row, i + 1)});
            }
    }

    std::uint32_t at(const std::array<std::uint32_t, 3>& face, int row, int i) {
        Name name{{{face[0], n_ - row}, {face[1], row - i}, {face[2], i}}};
        for (auto& [vertex, steps] : name)
            if (steps == 0)
                vertex = 0;
        std::sort(name.begin(), name.end());
        const auto [found, is_new] =
            numbers_.emplace(name, static_cast<std::uint32_t>(sphere_.directions.size()));
        if (is_new)
            sphere_.directions.push_back(direction(name));
        return found->second;
    }

    // From the sorted name, so that it does not depend on the face that asks first.
    WideVec3 direction(const Name& name) const {
        WideVec3 sum(0, 0, 0);
        int steps = 0;
        for (const auto& [vertex, more] : name) {
            if (more == 0)
                continue;
            steps += more;
            const WideVec3& v = solid_.vertices[vertex];
            sum = steps == more ? v : slerp(sum, v, double(more) / steps);
        }
        return sum.normalized();
    }

    GeodesicSphere& sphere_;
    int n_;
    Icosahedron solid_ = icosahedron();
    std::map<Name, std::uint32_t> numbers_;
};

/// The octahedral map (Praun & Hoppe 2003) as the octant with these signs has it, continued beyond
/// the octant's borders; into [-1, 1]^2 within the octant.
Vec2 octahedral(const WideVec3& d, const WideVec3& signs) {
    const WideVec3 p = d / (d ^ signs);
    if (signs.y > 0)
        return {p.x, p.z};
    return {signs.x * (1 - signs.z * p.z), signs.z * (1 - signs.x * p.x)};
}

WideVec3 signs_of(const WideVec3& d) {
    return {d.x < 0 ? -1.0 : 1.0, d.y < 0 ? -1.0 : 1.0, d.z < 0 ? -1.0 : 1.0};
}

void add_uvs(GeodesicSphere& sphere) {
    std::vector<Vec2> places;
    std::map<std::pair<std::uint32_t, int>, std::uint32_t> numbers; // of a direction in a chart
    for (const Mesh::Triangle& triangle : sphere.triangles) {
        WideVec3 middle(0, 0, 0);
        for (const std::uint32_t i : triangle)
            middle += sphere.directions[i];
        // Above the equator and across it the map is one chart; below it is cut along the seams.
        const WideVec3 chart = signs_of(middle);
        Mesh::Triangle corners;
        for (unsigned k = 0; k < 3; ++k) {
            const WideVec3& d = sphere.directions[triangle[k]];
            WideVec3 signs = signs_of(d);
            if (signs.y < 0 && (signs.x != chart.x || signs.z != chart.z))
                signs = {chart.x, -1.0, chart.z};
            const int key = signs.y > 0 ? 0 : 1 + (signs.x > 0 ? 1 : 0) + (signs.z > 0 ? 2 : 0);
            const auto [found, is_new] = numbers.emplace(std::pair(triangle[k], key),
                                                         static_cast<std::uint32_t>(places.size()));
            if (is_new) {
                places.push_back(octahedral(d, signs));
                sphere.direction_of_corner.push_back(triangle[k]);
            }
            corners[k] = found->second;
        }
        sphere.corner_triangles.push_back(corners);
    }
    // Triangles across a seam reach beyond the map's border: all of it is fitted into [0, 1]^2.
    double reach = 1;
    for (const Vec2& place : places)
        reach = std::max({reach, std::abs(place.x), std::abs(place.y)});
    for (const Vec2& place : places)
        sphere.uvs.emplace_back(Vec2(0.5) + place * (0.5 / reach));
}

} // namespace

std::shared_ptr<const GeodesicSphere> geodesic_sphere(int n) {
    assert(n >= 1 && n <= 128);
    static std::mutex mutex;
    static std::map<int, std::shared_ptr<const GeodesicSphere>> made;
    const std::scoped_lock lock(mutex);
    std::shared_ptr<const GeodesicSphere>& kept = made[n];
    if (!kept) {
        auto sphere = std::make_shared<GeodesicSphere>();
        Division division(*sphere, n);
        division.run();
        sphere->edge = std::sqrt(4 * pi / double(sphere->triangles.size()) * 4 / std::sqrt(3.0));
        add_uvs(*sphere);
        kept = std::move(sphere);
    }
    return kept;
}

} // namespace scree
