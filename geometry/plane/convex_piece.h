// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace scree {

/// A convex polygon of few corners, counter-clockwise: a part of a domain that may still be
/// uncovered.
struct ConvexPiece {
    static constexpr int capacity = 12;

    std::array<Vec2, capacity> corner; // the first `count` are set
    int count = 0;

    ConvexPiece() {} // not defaulted: it would fill the corners

    void add(const Vec2& point) { corner[static_cast<std::size_t>(count++)] = point; }
    const Vec2& operator[](int i) const { return corner[static_cast<std::size_t>(i)]; }
    const Vec2& after(int i) const { return (*this)[i + 1 < count ? i + 1 : 0]; }
};

inline double area(const ConvexPiece& piece) {
    double twice = 0;
    for (int i = 2; i < piece.count; ++i)
        twice += cross(piece[i - 1] - piece[0], piece[i] - piece[0]);
    return twice / 2;
}

inline Box2 bounds(const ConvexPiece& piece) {
    Box2 box(piece[0]);
    for (int i = 1; i < piece.count; ++i) {
        box.min = {std::min(box.min.x, piece[i].x), std::min(box.min.y, piece[i].y)};
        box.max = {std::max(box.max.x, piece[i].x), std::max(box.max.y, piece[i].y)};
    }
    return box;
}

/// A circle around the piece, about the middle of its bounding box.
struct BoundingCircle {
    Vec2 centre;
    double radius = 0;
};
inline BoundingCircle bounding_circle(const ConvexPiece& piece) {
    const Vec2 centre = bounds(piece).center();
    double radius2 = 0;
    for (int i = 0; i < piece.count; ++i)
        radius2 = std::max(radius2, (piece[i] - centre).length2());
    return {centre, std::sqrt(radius2)};
}

/// The point that two numbers in [0, 1) choose uniformly from the piece of the given area > 0 (the
/// fan of triangles from its first corner; Turk 1990 within one).
Vec2 point_in(const ConvexPiece& piece, double area, double u, double v);

/// Keeps what lies on the left of the directed line through `point` along `direction`. The result
/// has no corners when nothing does, and at most one more than before.
void keep_left(ConvexPiece& piece, const Vec2& point, const Vec2& direction);

/// Splits the piece into two across the longer side of its bounding box, or one of many corners
/// along a diagonal.
std::array<ConvexPiece, 2> halves(const ConvexPiece& piece);

/// The quadratic form of an ellipse: v is inside where at(v) is below a limit.
struct QuadraticForm {
    double xx = 1, xy = 0, yy = 1;

    double at(const Vec2& v) const { return v.x * v.x * xx + 2 * v.x * v.y * xy + v.y * v.y * yy; }
    double between(const Vec2& a, const Vec2& b) const {
        return a.x * b.x * xx + (a.x * b.y + a.y * b.x) * xy + a.y * b.y * yy;
    }

    /// The inverse of the shorter semi-axis of {v: at(v) < 1}: the root of the larger eigenvalue.
    double steepest() const {
        const double half = (xx - yy) / 2;
        return std::sqrt((xx + yy) / 2 + std::sqrt(half * half + xy * xy));
    }
};

/// The form of a disk.
struct RoundForm {
    double at(const Vec2& v) const { return v.x * v.x + v.y * v.y; }
    double between(const Vec2& a, const Vec2& b) const { return a.x * b.x + a.y * b.y; }
};

/// Takes from the piece what the ellipse {p: form.at(p - centre) < limit} surely covers: corners
/// inside give way to the chord between the edges' crossings, so that what is left is the convex
/// hull of the uncovered part, or more. Returns whether anything changed; a piece that is covered
/// whole has no corners left.
template <class Form>
bool cut_away(ConvexPiece& piece, const Vec2& centre, const Form& form, double limit);

} // namespace scree

#include "geometry/plane/convex_piece_inline.h"
