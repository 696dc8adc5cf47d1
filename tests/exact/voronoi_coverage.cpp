// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/exact/coverage.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

namespace scree::tests {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Segment = Kernel::Segment_2;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;

/// A region with the even-odd rule and exact arithmetic; its border belongs to it.
class ExactRegion {
  public:
    explicit ExactRegion(const Region& region) {
        for (const Ring& ring : region.rings) {
            rings_.emplace_back();
            for (const Vec2& v : ring)
                rings_.back().emplace_back(v.x, v.y);
        }
    }

    bool contains(const Point& point) const {
        bool inside = false;
        for (const std::vector<Point>& ring : rings_) {
            const CGAL::Bounded_side side =
                CGAL::bounded_side_2(ring.begin(), ring.end(), point, Kernel());
            if (side == CGAL::ON_BOUNDARY)
                return true;
            inside = inside != (side == CGAL::ON_BOUNDED_SIDE);
        }
        return inside;
    }

    template <class Visit>
    void each_edge(const Visit& visit) const {
        for (const std::vector<Point>& ring : rings_)
            for (std::size_t i = 0; i < ring.size(); ++i)
                visit(Segment(ring[i], ring[(i + 1) % ring.size()]));
    }

  private:
    std::vector<std::vector<Point>> rings_;
};

/// An edge of the Voronoi diagram, a segment or a ray from `from` along `direction`.
struct VoronoiEdge {
    Point from;
    Kernel::Vector_2 direction;
    bool endless = false;
    CGAL::Bbox_2 box; // of a segment
    Point site;       // one of its nearest sites
};

/// Visits the crossing of a Voronoi edge with an edge of the border. Parallel edges are ignored:
/// they meet at places that are tested anyway.
template <class Visit>
void visit_crossing(const VoronoiEdge& edge, const Segment& border, const Visit& visit) {
    if (!edge.endless && !CGAL::do_overlap(edge.box, border.bbox()))
        return;
    const Kernel::Vector_2 along = border.to_vector();
    const Kernel::FT turn = CGAL::determinant(along, edge.direction);
    if (CGAL::is_zero(turn))
        return;
    const Kernel::Vector_2 between = edge.from - border.source();
    const Kernel::FT on_border = CGAL::determinant(between, edge.direction) / turn;
    const Kernel::FT on_edge = CGAL::determinant(between, along) / turn;
    if (on_border >= 0 && on_border <= 1 && on_edge >= 0 && (edge.endless || on_edge <= 1))
        visit(border.source() + on_border * along);
}

std::vector<VoronoiEdge> voronoi_edges(const Delaunay& delaunay) {
    std::vector<VoronoiEdge> edges;
    for (auto edge = delaunay.finite_edges_begin(); edge != delaunay.finite_edges_end(); ++edge) {
        const Point& site = edge->first->vertex(Delaunay::cw(edge->second))->point();
        const CGAL::Object dual = delaunay.dual(edge);
        if (const auto* segment = CGAL::object_cast<Segment>(&dual))
            edges.push_back(
                {segment->source(), segment->to_vector(), false, segment->bbox(), site});
        else if (const auto* ray = CGAL::object_cast<Kernel::Ray_2>(&dual))
            edges.push_back({ray->source(), ray->to_vector(), true, {}, site});
    }
    return edges;
}

Delaunay delaunay_of(const std::vector<Vec2>& points, const Box2& box, bool torus) {
    std::vector<Point> all;
    for (const Vec2& p : points)
        for (int x = torus ? -1 : 0; x <= (torus ? 1 : 0); ++x)
            for (int y = torus ? -1 : 0; y <= (torus ? 1 : 0); ++y)
                all.emplace_back(Kernel::FT(p.x) + Kernel::FT(x) * Kernel::FT(box.size().x),
                                 Kernel::FT(p.y) + Kernel::FT(y) * Kernel::FT(box.size().y));
    return Delaunay(all.begin(), all.end());
}

} // namespace

std::size_t far_places(const std::vector<Vec2>& points, const Region& domain, bool torus,
                       double radius) {
    const Delaunay delaunay = delaunay_of(points, bounds(domain), torus);
    const ExactRegion region(domain);
    const Kernel::FT limit = Kernel::FT(radius) * Kernel::FT(radius);
    std::size_t count = 0;
    for (auto face = delaunay.finite_faces_begin(); face != delaunay.finite_faces_end(); ++face) {
        const Point centre = delaunay.circumcenter(face);
        if (CGAL::compare_squared_distance(centre, face->vertex(0)->point(), limit) ==
                CGAL::LARGER &&
            region.contains(centre))
            ++count;
    }
    if (torus)
        return count;
    const std::vector<VoronoiEdge> edges = voronoi_edges(delaunay);
    region.each_edge([&](const Segment& border) {
        const auto is_far = [&](const Point& place, const Point& site) {
            return CGAL::compare_squared_distance(place, site, limit) == CGAL::LARGER;
        };
        const auto nearest = delaunay.nearest_vertex(border.source());
        count += is_far(border.source(), nearest->point()) ? 1 : 0;
        for (const VoronoiEdge& edge : edges)
            visit_crossing(edge, border, [&](const Point& crossing) {
                count += is_far(crossing, edge.site) ? 1 : 0;
            });
    });
    return count;
}

} // namespace scree::tests
