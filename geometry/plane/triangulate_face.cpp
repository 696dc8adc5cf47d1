// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/triangulate_face.h"

#include "geometry/plane/winding_number.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

using Imath::V3d;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<bool, Kernel>>; // whether it was visited
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Face = Triangulation::Face_handle;

constexpr std::size_t small_face = 8;       // corners, of which a fan is tried
constexpr std::uint32_t unset = 0xffffffff; // index of a vertex that is no corner yet

void add_fan(std::size_t corners, std::size_t apex, FaceTriangles& out) {
    for (std::size_t k = 1; k + 1 < corners; ++k)
        out.triangles.push_back({std::uint32_t(apex), std::uint32_t((apex + k) % corners),
                                 std::uint32_t((apex + k + 1) % corners)});
}

// Newell's normal, of twice the area's length. Relative to a corner, so that no digits are lost far
// from the origin.
V3d newell_normal(std::span<const V3d> corners) {
    V3d normal(0.0);
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
    return normal;
}

// The normal of the plane to triangulate in: Newell's, or that of the largest triangle with the
// first corner when the parts of a face that crosses itself cancel out. 0: all lie on a line.
V3d plane_normal(std::span<const V3d> corners) {
    V3d largest(0.0);
    double reach = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const V3d from = corners[i] - corners[0];
        const V3d normal = from.cross(corners[i + 1] - corners[0]);
        if (normal.length2() > largest.length2())
            largest = normal;
        reach = std::max({reach, from.length2(), (corners[i + 1] - corners[0]).length2()});
    }
    const V3d normal = newell_normal(corners);
    const double rounding = 1e-14 * reach * double(corners.size());
    if (normal.length() > rounding)
        return normal;
    return largest.length() > rounding ? largest : V3d(0.0);
}

// The corners in coordinates of the plane, seen from the normal's tip. In planes across an axis
// they are exact, so that corners on a line stay there.
Ring flattened(std::span<const V3d> corners, const V3d& normal) {
    const V3d n = normal.normalized();
    const V3d a(std::abs(n.x), std::abs(n.y), std::abs(n.z));
    const V3d across = a.x <= a.y && a.x <= a.z ? V3d(1, 0, 0)
                       : a.y <= a.z             ? V3d(0, 1, 0)
                                                : V3d(0, 0, 1);
    const V3d u = (across - n * across.dot(n)).normalized();
    const V3d v = n.cross(u);
    Ring out;
    out.reserve(corners.size());
    for (const V3d& p : corners)
        out.emplace_back((p - corners[0]).dot(u), (p - corners[0]).dot(v));
    return out;
}

// Whether the corners lie around the apex in order and within half a turn: then the triangles of
// its fan do not overlap.
bool is_fan(const Ring& ring, std::size_t apex) {
    const auto to = [&](std::size_t k) { return ring[(apex + k) % ring.size()] - ring[apex]; };
    for (std::size_t k = 1; k + 1 < ring.size(); ++k)
        if (!(cross(to(k), to(k + 1)) > 0 && cross(to(1), to(k + 1)) > 0))
            return false;
    return true;
}

double area_of(const Face& face) {
    const auto p = [&](int i) {
        const auto& point = face->vertex(i)->point();
        return Vec2(point.x(), point.y());
    };
    return cross(p(1) - p(0), p(2) - p(0)) / 2;
}

class Triangulator {
  public:
    Triangulator(const Ring& ring, FaceTriangles& out)
        : ring_(ring), winding_number_(ring), out_(out) {}

    // False when all corners lie on a line.
    bool run() {
        insert();
        if (triangulation_.dimension() < 2)
            return false;
        for (const Face face : triangulation_.all_face_handles())
            face->info() = false;
        for (const Face face : triangulation_.finite_face_handles())
            if (!face->info())
                add_part(face);
        return !out_.triangles.empty();
    }

  private:
    void insert() {
        std::vector<Triangulation::Vertex_handle> vertices;
        Face near;
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            const std::size_t before = triangulation_.number_of_vertices();
            vertices.push_back(triangulation_.insert({ring_[i].x, ring_[i].y}, near));
            if (triangulation_.number_of_vertices() > before) // the first corner at this place
                vertices.back()->info() = static_cast<std::uint32_t>(i);
            near = vertices.back()->face();
        }
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            const auto from = vertices[i];
            const auto to = vertices[(i + 1) % ring_.size()];
            if (from == to)
                continue;
            try {
                triangulation_.insert_constraint(from, to);
            } catch (const Triangulation::Intersection_of_constraints_exception&) {
                out_.crosses_itself = true; // this edge does not bound triangles
            }
        }
    }

    // Takes the triangles of a part that edges bound if the polygon winds around it. Where edges
    // cross, not all of them bound parts; then every triangle is one.
    void add_part(const Face& start) {
        part_.assign(1, start);
        start->info() = true;
        bool outside = false;
        Face largest = start;
        for (std::size_t next = 0; next < part_.size(); ++next) {
            const Face face = part_[next];
            if (area_of(face) > area_of(largest))
                largest = face;
            for (int i = 0; i < 3; ++i) {
                const Face neighbour = face->neighbor(i);
                if (out_.crosses_itself || face->is_constrained(i) || neighbour->info())
                    continue;
                if (triangulation_.is_infinite(neighbour)) {
                    outside = true;
                    continue;
                }
                neighbour->info() = true;
                part_.push_back(neighbour);
            }
        }
        const int turns = outside ? 0 : winding_number_(centroid(largest));
        if (turns == 0)
            return;
        for (const Face& face : part_)
            out_.triangles.push_back({face->vertex(0)->info(),
                                      face->vertex(turns > 0 ? 1 : 2)->info(),
                                      face->vertex(turns > 0 ? 2 : 1)->info()});
    }

    static Vec2 centroid(const Face& face) {
        Vec2 sum(0.0);
        for (int i = 0; i < 3; ++i)
            sum += Vec2(face->vertex(i)->point().x(), face->vertex(i)->point().y());
        return sum / 3;
    }

    const Ring& ring_;
    WindingNumber winding_number_;
    FaceTriangles& out_;
    Triangulation triangulation_;
    std::vector<Face> part_;
};

} // namespace

FaceTriangles triangulate_face(std::span<const V3d> corners) {
    assert(corners.size() >= 3);
    FaceTriangles out;
    const V3d normal = plane_normal(corners);
    if (corners.size() == 3 || normal == V3d(0.0)) {
        add_fan(corners.size(), 0, out);
        return out;
    }
    const Ring ring = flattened(corners, normal);
    if (corners.size() <= small_face)
        for (std::size_t apex = 0; apex < corners.size(); ++apex)
            if (is_fan(ring, apex)) {
                add_fan(corners.size(), apex, out);
                return out;
            }
    if (!Triangulator(ring, out).run())
        add_fan(corners.size(), 0, out);
    return out;
}

} // namespace scree
