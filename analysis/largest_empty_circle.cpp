// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/largest_empty_circle.h"

#include "core/parallel.h"

#include <algorithm>
#include <queue>

namespace scree {

namespace {

struct Square {
    Vec2 centre;
    double half = 0;      // half of the side
    double clearance = 0; // at the centre

    // An upper bound over the square, since the clearance is 1-Lipschitz.
    double bound() const { return clearance + half * std::sqrt(2.0); }
    bool operator<(const Square& other) const { return bound() < other.bound(); }
};

} // namespace

Circle largest_empty_circle(const PlacedRegions& regions, const RegionDistance& distance,
                            double tolerance) {
    const Region& domain = *regions.window.domain;
    const Box2 box = bounds(domain);
    const Vec2 size = box.size();
    const auto clearance = [&](const Vec2& p) {
        const double border = regions.window.torus ? std::numeric_limits<double>::infinity()
                                                   : -signed_distance(domain, p);
        // On a torus a circle must not meet its own periodic images.
        const double self = regions.window.torus ? std::min(size.x, size.y) / 2
                                                 : std::numeric_limits<double>::infinity();
        return border <= 0 ? border : std::min({border, self, distance(p)});
    };

    // The search starts with about one square per element, evaluated in parallel.
    const double count = std::max(64.0, double(regions.positions.size()));
    const double side = std::min({std::sqrt(size.x * size.y / count), size.x, size.y});
    const auto columns = static_cast<std::size_t>(std::ceil(size.x / side));
    const auto rows = static_cast<std::size_t>(std::ceil(size.y / side));
    std::vector<Square> squares(columns * rows);
    parallel_for(squares.size(), 64, [&](std::size_t i) {
        const Vec2 centre =
            box.min + Vec2(double(i % columns) + 0.5, double(i / columns) + 0.5) * side;
        squares[i] = {centre, side / 2, clearance(centre)};
    });

    Circle best;
    const auto improve = [&](const Square& square) {
        if (square.clearance > best.radius)
            best = {square.centre, square.clearance};
    };
    std::for_each(squares.begin(), squares.end(), improve);
    const auto hopeless = [&](const Square& square) {
        return square.bound() <= best.radius * (1 + tolerance) ||
               square.half < tolerance * 1e-3 * side;
    };
    std::erase_if(squares, hopeless);
    std::priority_queue<Square> open({}, std::move(squares));
    while (!open.empty() && !hopeless(open.top())) {
        const Square parent = open.top();
        open.pop();
        for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)}) {
            Square child{parent.centre + corner * (parent.half / 2), parent.half / 2, 0};
            child.clearance = clearance(child.centre);
            improve(child);
            if (!hopeless(child))
                open.push(child);
        }
    }
    return best;
}

} // namespace scree
