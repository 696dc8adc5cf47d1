// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/search_problem.h"

#include "geometry/figures/convex_cover.h"
#include "geometry/plane/region_tools.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

bool looks_the_same(const Region& region, double turn, double tolerance) {
    for (const Ring& ring : region.rings) {
        for (const Vec2& v : ring) {
            const Vec2 turned = rotate(v, turn);
            const bool found = std::ranges::any_of(region.rings, [&](const Ring& other) {
                return std::ranges::any_of(other, [&](const Vec2& w) {
                    return (w - turned).length2() < tolerance * tolerance;
                });
            });
            if (!found)
                return false;
        }
    }
    return true;
}

bool smaller_is_easier(const LayoutProblem& problem, const Region& region) {
    const Ring seeing = kernel(region);
    if (seeing.empty())
        return false;
    // About the centre of transformation, a smaller copy lies within a larger one. About another
    // point it must be moved to, which fields and a test of centres would notice.
    const bool centre_sees = contains({.rings = {seeing}, .vertices = {}, .triangles = {}}, {0, 0});
    const LayoutFields& f = problem.fields;
    const bool may_move = problem.domain.inside() != Inside::centre && !f.direction && !f.scale &&
                          !f.density && !f.classes;
    return centre_sees || may_move;
}

/// The plane around the domain, as far as elements reach.
std::vector<NoFitPiece> outside_of(const LayoutProblem& problem, double reach, double corner) {
    Box2 box = problem.domain.box();
    box.min -= Vec2(reach);
    box.max += Vec2(reach);
    std::vector<Ring> rings = problem.domain.region().rings;
    rings.push_back({box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}});
    std::vector<NoFitPiece> pieces;
    for (const Ring& ring : convex_partition(triangulate(rings)))
        if (ring.size() >= 3)
            pieces.emplace_back(ring, corner);
    return pieces;
}

} // namespace

void check_epsilon(const LayoutProblem& problem, double epsilon) {
    const double radius = problem.largest_radius() + problem.largest_margin();
    const double least = 4 * (problem.clearance() + 32 * 0x1p-24 * 4 * radius);
    if (epsilon < least)
        throw Error(fmt::format("epsilon, {:.3g} m, is too small beside elements of {:.3g} m; the "
                                "least is {:.3g} m",
                                epsilon, 2 * radius, least));
}

double expected_seconds(const LayoutProblem& problem) {
    constexpr double seconds_per_pair = 0.14e-3;
    constexpr double usual_fill = 0.55;
    constexpr double rounded_corners = 4; // by margins that vary: each piece has many more corners
    double pieces = 0, area = 0;
    for (const CollisionShape& shape : problem.shapes) {
        const auto count = double(convex_cover(triangulate(shape.outline().rings)).size());
        const bool all_scales =
            problem.scale.high > problem.scale.low && !smaller_is_easier(problem, shape.outline());
        pieces += count * (all_scales ? 2 : 1);
        area += shape.area() / double(problem.shapes.size());
    }
    const double scale =
        (problem.scale.low + problem.scale.high) / 2 * problem.scale_over(problem.domain.box()).low;
    const double elements =
        usual_fill * scree::area(problem.domain.region()) / (area * scale * scale);
    return seconds_per_pair * elements * pieces * pieces / double(problem.shapes.size()) *
           (problem.fields.density ? rounded_corners : 1);
}

double turn_period(const Region& region) {
    const Box2 box = bounds(region);
    const double tolerance = 1e-7 * box.size().length();
    std::size_t corners = 0;
    for (const Ring& ring : region.rings)
        corners += ring.size();
    for (std::size_t parts = std::min<std::size_t>(corners, 360); parts > 1; --parts)
        if (looks_the_same(region, 2 * pi / double(parts), tolerance))
            return 2 * pi / double(parts);
    return 2 * pi;
}

SearchProblem::SearchProblem(const LayoutProblem& problem, double wanted)
    : layout(problem), epsilon(wanted), clearance(problem.clearance()),
      largest_margin(problem.largest_margin()) {
    const Box2 whole = problem.domain.box();
    const double radius = problem.largest_radius() + largest_margin;
    check_epsilon(problem, epsilon);
    sliver = static_cast<float>(epsilon / 100);
    // Coordinates are about a box's centre and no larger than two elements; each no-fit polygon
    // sums a few of them (2^-24 each), as does a fragment's cut.
    safety = epsilon / 100 + 0.01 * epsilon + 32 * 0x1p-24 * 4 * radius;
    // Moving edges by the clearance and margins moves corners farther: the sharper, the less
    // accurately. A quarter of epsilon may be lost to that.
    const double margins = 2 * largest_margin;
    const double corner =
        margins > 0 ? 2 * std::acos(1 - 0.25 * epsilon / (margins + epsilon)) : pi / 2;
    double blunt = 1;
    for (const CollisionShape& shape : problem.shapes) {
        SearchShape prepared;
        for (const Ring& ring : convex_cover(triangulate(shape.outline().rings))) {
            const Ring simple = simplify_inward(
                ring, epsilon / (16 * problem.scale.high * problem.scale_over(whole).high));
            prepared.pieces.emplace_back(simple, std::max(corner, 1e-3));
            const double coarse = 0.08 * shape.inner_radius();
            coarse_loss = std::max(coarse_loss, 2 * coarse * problem.scale.high *
                                                    problem.scale_over(whole).high);
            prepared.coarse.emplace_back(simplify_inward(ring, coarse), pi);
            blunt = std::min(blunt, prepared.pieces.back().corner_cosine);
        }
        prepared.turn_radius = shape.radius();
        prepared.turn_period = turn_period(shape.outline());
        prepared.smaller_is_easier = smaller_is_easier(problem, shape.outline());
        shapes.push_back(std::move(prepared));
    }
    if (problem.domain.inside() == Inside::whole)
        outside = outside_of(problem, 2 * radius + epsilon, corner);
    if (problem.domain.inside() == Inside::centre)
        for (const Ring& ring : convex_partition(problem.domain.region()))
            if (ring.size() >= 3)
                inside.emplace_back(ring, pi);
    // How much wider the no-fit polygons are than the elements, less the clearance that placed
    // elements keep and the error of the simplified pieces.
    const double net = blunt * (epsilon - safety + margins) - margins - clearance - epsilon / 8;
    smallest_extent = 0.8 * net;
    coarse_extent = 0.15 * problem.smallest_inner_radius();
    dart_extent = 0.5 * problem.smallest_inner_radius();
}

} // namespace scree
