// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/spline.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

struct Knot {
    Vec2 at;
    bool corner = false;
};

std::vector<Knot> knots_of(const std::vector<Vec2>& points, bool closed) {
    std::vector<Knot> knots;
    for (const Vec2& p : points) {
        if (!knots.empty() && knots.back().at == p)
            knots.back().corner = true;
        else
            knots.push_back({p});
    }
    if (closed && knots.size() > 1 && knots.front().at == knots.back().at) {
        knots.pop_back();
        knots.front().corner = true;
    }
    return knots;
}

double knot_step(const Vec2& a, const Vec2& b) { return std::sqrt((b - a).length()); }

// The derivative at b of the parabola through a, b and c, scaled to the parameter of a span of
// length `span`.
Vec2 tangent(const Vec2& a, const Vec2& b, const Vec2& c, double span) {
    const double before = knot_step(a, b);
    const double after = knot_step(b, c);
    return ((b - a) / before - (c - a) / (before + after) + (c - b) / after) * span;
}

// Appends the span from b to c. b itself is appended only to an empty piece.
void add_span(CurvePiece& piece, const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d,
              int steps) {
    const double span = knot_step(b, c);
    const Vec2 chord = c - b;
    const Vec2 start = tangent(a, b, c, span);
    const Vec2 end = tangent(b, c, d, span);
    if (piece.empty())
        piece.push_back({b, start});
    const double straight = 1e-9 * chord.dot(chord);
    if (std::abs(cross(start, chord)) < straight && std::abs(cross(end, chord)) < straight)
        steps = 1;
    for (int k = 1; k < steps; ++k) { // cubic Hermite interpolation
        const double t = double(k) / steps;
        const double u = 1 - t;
        piece.push_back(
            {b * (u * u * (1 + 2 * t)) + c * (t * t * (1 + 2 * u)) +
                 (start * u - end * t) * (t * u),
             chord * (6 * t * u) + start * (u * (1 - 3 * t)) + end * (t * (3 * t - 2))});
    }
    piece.push_back({c, end});
}

} // namespace

std::vector<CurvePiece> spline(const std::vector<Vec2>& points, bool closed, int steps) {
    std::vector<Knot> knots = knots_of(points, closed);
    const std::size_t n = knots.size();
    assert(n >= (closed ? 3U : 2U));
    const auto first_corner =
        std::find_if(knots.begin(), knots.end(), [](const Knot& knot) { return knot.corner; });
    const bool endless = closed && first_corner == knots.end();
    if (closed && !endless)
        std::rotate(knots.begin(), first_corner, knots.end());

    const std::size_t spans = closed ? n : n - 1;
    // The control point beyond an end: the mirror image when the end lies on the axis, otherwise
    // the straight continuation.
    const auto beyond = [&](std::size_t end, std::size_t inner) {
        const Vec2 p = knots[inner % n].at;
        const Knot& last = knots[end % n];
        const bool on_axis = last.at.x == 0 && !last.corner;
        return on_axis ? Vec2(-p.x, p.y) : last.at * 2.0 - p;
    };
    const auto is_end = [&](std::size_t i) {
        return !endless && (i == 0 || i == spans || knots[i % n].corner);
    };
    std::vector<CurvePiece> pieces(1);
    for (std::size_t i = 0; i < spans; ++i) {
        const Vec2 before = is_end(i) ? beyond(i, i + 1) : knots[(i + n - 1) % n].at;
        const Vec2 after = is_end(i + 1) ? beyond(i + 1, i) : knots[(i + 2) % n].at;
        add_span(pieces.back(), before, knots[i % n].at, knots[(i + 1) % n].at, after, steps);
        if (is_end(i + 1) && i + 1 < spans)
            pieces.emplace_back();
    }
    return pieces;
}

std::vector<CurvePiece> polyline(const std::vector<Vec2>& points, bool closed) {
    std::vector<CurvePiece> pieces;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < (closed ? n : n - 1); ++i) {
        const Vec2& a = points[i];
        const Vec2& b = points[(i + 1) % n];
        if (a != b)
            pieces.push_back({{a, b - a}, {b, b - a}});
    }
    return pieces;
}

} // namespace scree
