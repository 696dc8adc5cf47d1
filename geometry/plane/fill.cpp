// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "geometry/plane/region_tools.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace scree {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
/// Of a vertex: how many corners of the filled area meet there.
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
/// Of a face: which part of the plane it belongs to.
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
/// This kind keeps the original edges, so that crossings do not depend on earlier crossings.
using Triangulation =
    CGAL::Constrained_triangulation_plus_2<CGAL::Constrained_Delaunay_triangulation_2<
        Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
        CGAL::Exact_intersections_tag>>;
using Face = Triangulation::Face_handle;
using Vertex = Triangulation::Vertex_handle;

/// A triangle's side with the triangle to its left, from vertex ccw(side) to vertex cw(side).
using HalfEdge = Triangulation::Edge;

/// Relative to the longest side: all points lie on a grid of this step, so that what rounding
/// would make cross or nearly touch coincides instead.
constexpr double grid_share = 0x1p-30;
/// The distance by which parts that touch in a point are separated, and the least size of a part.
constexpr double detail_share = 1e-5;

struct ExactShape {
    std::vector<std::vector<Point>> rings;
    FillRule rule;
    std::vector<std::size_t> within;

    int winding_number(const Point& p) const {
        int number = 0;
        for (const std::vector<Point>& ring : rings) {
            for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
                const bool from_above = CGAL::compare_y(ring[j], p) == CGAL::LARGER;
                const bool to_above = CGAL::compare_y(ring[i], p) == CGAL::LARGER;
                if (from_above == to_above)
                    continue;
                const CGAL::Orientation side = CGAL::orientation(ring[j], ring[i], p);
                if (to_above && side == CGAL::LEFT_TURN)
                    ++number;
                else if (from_above && side == CGAL::RIGHT_TURN)
                    --number;
            }
        }
        return number;
    }

    bool fills(const Point& p) const {
        const int number = winding_number(p);
        return rule == FillRule::nonzero ? number != 0 : number % 2 != 0;
    }
};

/// The plane cut into triangles along all edges, which are also cut where they cross.
class Arrangement {
  public:
    Arrangement(const std::vector<FilledRings>& shapes, const Clips& clips, double longest)
        : step_(std::exp2(std::floor(std::log2(longest * grid_share)))),
          detail_(longest * detail_share) {
        for (const FilledRings& shape : shapes)
            shapes_.push_back(inserted(shape));
        for (const std::vector<FilledRings>& clip : clips) {
            clips_.emplace_back();
            for (const FilledRings& shape : clip)
                clips_.back().push_back(inserted(shape));
        }
        number_parts();
        mark_filled();
    }

    /// The filled area to the left of its rings, which may still touch after rounding.
    std::vector<Ring> rings() {
        for (const Vertex vertex : triangulation_.finite_vertex_handles())
            vertex->info() = 0;
        std::vector<HalfEdge> starts;
        for (Face face : triangulation_.finite_face_handles())
            for (int side = 0; side < 3; ++side)
                if (is_border({face, side})) {
                    starts.emplace_back(face, side);
                    ++face->vertex(Triangulation::cw(side))->info();
                }
        std::vector<Ring> out;
        std::set<std::pair<Face, int>> seen;
        for (const HalfEdge& start : starts) {
            std::vector<Vertex> corners;
            for (HalfEdge edge = start; seen.insert(edge).second; edge = next(edge))
                corners.push_back(edge.first->vertex(Triangulation::cw(edge.second)));
            Ring ring = rounded(corners);
            if (ring.size() >= 3 && std::abs(signed_area(ring)) > detail_ * detail_)
                out.push_back(std::move(ring));
        }
        return out;
    }

  private:
    double on_grid(double v) const { return std::round(v / step_) * step_; }

    /// The shape, whose edges now cut the plane.
    ExactShape inserted(const FilledRings& shape) {
        ExactShape exact{{}, shape.rule, shape.within};
        for (const Ring& ring : shape.rings) {
            std::vector<Point> points;
            Vec2 before(std::nan(""));
            for (const Vec2& v : ring) {
                const Vec2 snapped(on_grid(v.x), on_grid(v.y));
                if (snapped != before)
                    points.emplace_back(snapped.x, snapped.y);
                before = snapped;
            }
            if (points.size() < 3)
                continue;
            std::vector<Vertex> vertices;
            Face near;
            for (const Point& p : points) {
                vertices.push_back(triangulation_.insert(p, near));
                near = vertices.back()->face();
            }
            for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
                if (vertices[i] != vertices[j])
                    triangulation_.insert_constraint(vertices[j], vertices[i]);
            exact.rings.push_back(std::move(points));
        }
        return exact;
    }

    /// Numbers the connected parts between the edges; part 0 is outside.
    void number_parts() {
        for (Face face : triangulation_.all_face_handles())
            face->info() = -1;
        if (triangulation_.dimension() < 2)
            return;
        flood(triangulation_.infinite_face(), 0);
        for (Face face : triangulation_.finite_face_handles())
            if (face->info() == -1)
                flood(face, static_cast<int>(largest_.size()) + 1);
    }

    void flood(Face from, int part) {
        double largest = -1;
        Face best;
        std::vector<Face> stack{from};
        from->info() = part;
        while (!stack.empty()) {
            const Face face = stack.back();
            stack.pop_back();
            if (part > 0) {
                const double area = CGAL::to_double(triangulation_.triangle(face).area());
                if (area > largest)
                    best = face;
                largest = std::max(largest, area);
            }
            for (int side = 0; side < 3; ++side) {
                const Face neighbour = face->neighbor(side);
                if (neighbour->info() != -1 || face->is_constrained(side))
                    continue;
                neighbour->info() = part;
                stack.push_back(neighbour);
            }
        }
        if (part > 0)
            largest_.push_back(best);
    }

    void mark_filled() {
        filled_.assign(largest_.size() + 1, false);
        for (std::size_t i = 0; i < largest_.size(); ++i) {
            const auto triangle = triangulation_.triangle(largest_[i]);
            const Point inside = CGAL::centroid(triangle);
            filled_[i + 1] = is_in_any(shapes_, inside);
        }
    }

    bool is_in_any(const std::vector<ExactShape>& shapes, const Point& p) const {
        return std::any_of(shapes.begin(), shapes.end(), [&](const ExactShape& shape) {
            return shape.fills(p) &&
                   std::all_of(shape.within.begin(), shape.within.end(),
                               [&](std::size_t clip) { return is_in_any(clips_[clip], p); });
        });
    }

    bool is_filled(Face face) const { return filled_[static_cast<std::size_t>(face->info())]; }

    bool is_border(const HalfEdge& edge) const {
        return is_filled(edge.first) && !is_filled(edge.first->neighbor(edge.second));
    }

    /// Turns about the edge's end through the filled triangles there.
    HalfEdge next(const HalfEdge& edge) const {
        const Vertex end = edge.first->vertex(Triangulation::cw(edge.second));
        HalfEdge leaving{edge.first, Triangulation::ccw(edge.second)};
        while (!is_border(leaving)) {
            const Face face = leaving.first->neighbor(leaving.second);
            leaving = {face, Triangulation::cw(face->index(end))};
        }
        return leaving;
    }

    Vec2 position(Vertex vertex) const {
        return {CGAL::to_double(vertex->point().x()), CGAL::to_double(vertex->point().y())};
    }

    /// Where several corners of the area meet, the pointed ones are cut off, so that parts and
    /// holes are apart; at most one is not pointed.
    Ring rounded(const std::vector<Vertex>& corners) const {
        Ring ring;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vertex before = corners[(i + corners.size() - 1) % corners.size()];
            const Vertex corner = corners[i];
            const Vertex after = corners[(i + 1) % corners.size()];
            const CGAL::Orientation turn =
                CGAL::orientation(before->point(), corner->point(), after->point());
            const Vec2 at = position(corner);
            if (corner->info() > 1 && turn == CGAL::LEFT_TURN) {
                for (const Vertex neighbour : {before, after}) {
                    const Vec2 edge = position(neighbour) - at;
                    ring.push_back(at + edge * std::min(0.25, detail_ / edge.length()));
                }
            } else if (turn != CGAL::COLLINEAR) {
                ring.emplace_back(on_grid(at.x), on_grid(at.y));
            }
        }
        return ring;
    }

    double step_;
    double detail_;
    Triangulation triangulation_;
    std::vector<ExactShape> shapes_;
    std::vector<std::vector<ExactShape>> clips_;
    std::vector<Face> largest_; // of parts 1, 2, ...
    std::vector<bool> filled_;  // by part
};

double longest_side(const std::vector<FilledRings>& shapes) {
    Box2 box;
    for (const FilledRings& shape : shapes)
        for (const Ring& ring : shape.rings)
            for (const Vec2& v : ring) {
                if (!std::isfinite(v.x) || !std::isfinite(v.y))
                    throw Error("a point of the outline is not finite");
                box.extendBy(v);
            }
    const Vec2 size = box.isEmpty() ? Vec2(0.0) : box.size();
    return std::max(size.x, size.y);
}

} // namespace

Region fill(std::vector<FilledRings> shapes, const Clips& clips) {
    const double longest = longest_side(shapes);
    if (!(longest > 0) || !std::isfinite(longest))
        throw Error("the outline encloses no area");
    for (const std::vector<FilledRings>& clip : clips)
        longest_side(clip); // is finite
    // Points where edges cross are rounded, after which edges may cross or touch again: then the
    // result is filled again. One pass is usual; a third was never needed in tests.
    constexpr int most_rounds = 8;
    for (int round = 1;; ++round) {
        std::vector<Ring> rings =
            Arrangement(shapes, round == 1 ? clips : Clips(), longest).rings();
        if (rings.empty())
            throw Error("the outline encloses no area");
        try {
            return triangulate(rings);
        } catch (const Error&) {
            if (round == most_rounds)
                throw;
        }
        shapes = {FilledRings{std::move(rings), FillRule::nonzero}};
    }
}

} // namespace scree
