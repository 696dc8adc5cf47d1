// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/elements/exclusive_ellipse.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace scree {

namespace {

// Tangents and turns are sampled in steps of a degree: a needle that is 30 times as long as wide
// gets 1% more room than it needs, wider shapes less.
constexpr int half_turn = 180;
constexpr double step = pi / half_turn;

/// Squares of the corners' coordinates about the middle of the bounding box.
std::vector<Vec2> squared_offsets(const Region& region) {
    const Vec2 centre = bounds(region).center();
    std::vector<Vec2> squares;
    for (const Ring& ring : region.rings)
        for (const Vec2& v : ring)
            squares.push_back((v - centre) * (v - centre));
    return squares;
}

/// Distance from the middle of an ellipse to its tangents, for normals at whole steps from its long
/// axis, over half a turn; then they repeat.
std::vector<double> tangent_distances(const EllipseAxes& axes) {
    std::vector<double> distances;
    for (int i = 0; i < half_turn; ++i)
        distances.push_back(
            std::hypot(axes.length * std::cos(i * step), axes.width * std::sin(i * step)));
    return distances;
}

/// Where two ellipses touch: the centre of each as seen from the other, along and across its axes.
struct Touch {
    Vec2 from_a;
    Vec2 from_b;
};

/// All ways in which two ellipses touch with angles up to `spread` between them. The centre of one
/// then lies on the border of their Minkowski sum, whose tangents have the sums of their tangents'
/// distances; the polygon of the sampled tangents contains that border. As ellipses are symmetric,
/// only angles up to a right angle and half of the directions differ.
std::vector<Touch> touches(const EllipseAxes& a, const EllipseAxes& b, double spread) {
    const std::vector<double> of_a = tangent_distances(a), of_b = tangent_distances(b);
    constexpr int reach = half_turn / 2 - 1; // farther away a tangent does not meet the direction
    std::vector<double> secants;
    for (int i = -reach; i <= reach; ++i)
        secants.push_back(1 / std::cos(i * step));
    std::vector<double> sums(2 * half_turn + 2 * reach);
    std::vector<Touch> result;
    const int turns = static_cast<int>(std::ceil(std::min(spread, pi / 2) / step - 1e-9));
    for (int turn = 0; turn <= turns; ++turn) {
        for (std::size_t i = 0; i < sums.size(); ++i) { // the first is `reach` before direction 0
            const int normal = static_cast<int>(i) - reach + half_turn;
            sums[i] = of_a[std::size_t(normal % half_turn)] +
                      of_b[std::size_t((normal - turn + half_turn) % half_turn)];
        }
        for (int towards = 0; towards < half_turn; ++towards) {
            double distance = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < secants.size(); ++i)
                distance = std::min(distance, sums[std::size_t(towards) + i] * secants[i]);
            result.push_back({rotate({distance, 0}, towards * step),
                              rotate({distance, 0}, (towards - turn) * step)});
        }
    }
    return result;
}

/// Half the width of the ellipse `length` long on whose border the point lies.
double width_through(const Vec2& point, double length) {
    const double along = point.x / length;
    if (std::abs(along) < 1)
        return std::abs(point.y) / std::sqrt(1 - along * along);
    return std::numeric_limits<double>::infinity();
}

} // namespace

EllipseAxes enclosing_ellipse(const Region& region) {
    // With p and q the inverse squares of the axes every corner asks for p x^2 + q y^2 <= 1, and
    // the least area has the greatest p q: for each p the greatest q is the least of linear
    // functions, and p q(p) has one maximum.
    const std::vector<Vec2> squares = squared_offsets(region);
    const auto greatest_q = [&](double p) {
        double q = std::numeric_limits<double>::infinity();
        for (const Vec2& s : squares)
            if (s.y > 0)
                q = std::min(q, std::max(0.0, 1 - p * s.x) / s.y);
        return q;
    };
    double longest = 0;
    for (const Vec2& s : squares)
        longest = std::max(longest, s.x);
    double low = 0, high = 1 / longest;
    for (int i = 0; i < 100; ++i) {
        const double third = (high - low) / 3;
        const double a = low + third, b = high - third;
        if (a * greatest_q(a) < b * greatest_q(b))
            low = a;
        else
            high = b;
    }
    const double p = (low + high) / 2;
    return {1 / std::sqrt(p), 1 / std::sqrt(greatest_q(p))};
}

EllipseAxes enclosing_disk(const Region& region) {
    double most = 0;
    for (const Vec2& s : squared_offsets(region))
        most = std::max(most, s.x + s.y);
    return {std::sqrt(most), std::sqrt(most)};
}

EllipseAxes exclusive_ellipse(const EllipseAxes& half, double spread) {
    if (half.length < half.width) {
        const EllipseAxes turned = exclusive_ellipse({half.width, half.length}, spread);
        return {turned.width, turned.length};
    }
    if (spread <= 0 || half.length == half.width)
        return {2 * half.length, 2 * half.width};
    // A longer ellipse may be much slimmer, for what lies beyond the tips is never far to the side.
    const std::vector<Touch> all = touches(half, half, spread);
    EllipseAxes best{2 * half.length, 2 * half.length};
    for (int percent = 1; percent <= 60; ++percent) {
        EllipseAxes axes{2 * half.length * (1 + 0.01 * percent), 2 * half.width};
        for (const Touch& touch : all)
            axes.width = std::max(axes.width, std::min(width_through(touch.from_a, axes.length),
                                                       width_through(touch.from_b, axes.length)));
        if (axes.mean() < best.mean())
            best = axes;
    }
    return best;
}

double class_distance(const ElementRoom& a, const ElementRoom& b, double spread) {
    const auto reach = [](const EllipseAxes& axes, const Vec2& point) {
        return axes.mean() * std::hypot(point.x / axes.length, point.y / axes.width);
    };
    double distance = 0;
    for (const Touch& touch : touches(a.half, b.half, spread))
        distance = std::max(
            distance, std::min(reach(a.exclusive, touch.from_a), reach(b.exclusive, touch.from_b)));
    return distance;
}

} // namespace scree
