// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/convex_piece.h"

#include <cassert>

namespace scree {

Vec2 point_in(const ConvexPiece& piece, double area, double u, double v) {
    double wanted = 2 * area * u;
    for (int i = 2; i < piece.count; ++i) {
        const Vec2 a = piece[i - 1] - piece[0];
        const Vec2 b = piece[i] - piece[0];
        const double twice = cross(a, b);
        if (wanted < twice || i + 1 == piece.count) {
            // What is left of u is uniform in the triangle that it chose.
            const double root = std::sqrt(std::min(wanted / std::max(twice, 1e-300), 1.0));
            return piece[0] + (a + (b - a) * v) * root;
        }
        wanted -= twice;
    }
    return piece[0];
}

void keep_left(ConvexPiece& piece, const Vec2& point, const Vec2& direction) {
    assert(piece.count < ConvexPiece::capacity);
    ConvexPiece left;
    for (int i = 0; i < piece.count; ++i) {
        const double here = cross(direction, piece[i] - point);
        const double next = cross(direction, piece.after(i) - point);
        if (here >= 0)
            left.add(piece[i]);
        if ((here > 0 && next < 0) || (here < 0 && next > 0)) {
            left.add(piece[i] + (piece.after(i) - piece[i]) * (here / (here - next)));
        }
    }
    piece = left;
}

std::array<ConvexPiece, 2> halves(const ConvexPiece& piece) {
    // A piece of almost as many corners as it can hold is split along a diagonal, which gives each
    // half fewer corners. Other pieces are not: one half may be as large as the piece.
    if (piece.count >= ConvexPiece::capacity - 1) {
        const int middle = piece.count / 2;
        std::array<ConvexPiece, 2> result;
        for (int i = 0; i <= middle; ++i)
            result[0].add(piece[i]);
        for (int i = middle; i < piece.count; ++i)
            result[1].add(piece[i]);
        result[1].add(piece[0]);
        return result;
    }
    const Box2 box = bounds(piece);
    const Vec2 size = box.size();
    const Vec2 direction = size.x > size.y ? Vec2(0, 1) : Vec2(1, 0);
    std::array<ConvexPiece, 2> result{piece, piece};
    keep_left(result[0], box.center(), direction);
    keep_left(result[1], box.center(), -direction);
    return result;
}

} // namespace scree
