// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace scree {

template <class Form>
bool cut_away(ConvexPiece& piece, const Vec2& centre, const Form& form, double limit) {
    std::array<double, ConvexPiece::capacity> excess;
    int inside = 0;
    for (int i = 0; i < piece.count; ++i) {
        excess[static_cast<std::size_t>(i)] = form.at(piece[i] - centre) - limit;
        inside += excess[static_cast<std::size_t>(i)] < 0;
    }
    if (inside == 0)
        return false;
    if (inside == piece.count) {
        piece.count = 0;
        return true;
    }
    int runs = 0; // of corners inside; each becomes two crossings
    for (int i = 0, last = piece.count - 1; i < piece.count; last = i++)
        runs +=
            excess[static_cast<std::size_t>(last)] >= 0 && excess[static_cast<std::size_t>(i)] < 0;
    if (piece.count - inside + 2 * runs > ConvexPiece::capacity)
        return false;
    // Where the segment from a corner outside to one inside enters the ellipse, and a little
    // beyond, so that rounding never leaves a sliver along an edge that was cut before.
    const double rim = limit * (1 - 1e-14);
    const auto crossing = [&](const Vec2& out, double out_excess, const Vec2& in) {
        const Vec2 d = in - out;
        const double a = form.at(d);
        const double b = -form.between(out - centre, d); // half the linear term, above 0
        const double to_rim = out_excess + (limit - rim);
        const double root = std::sqrt(std::max(b * b - a * to_rim, 0.0));
        const double t = to_rim / (b + root); // without cancellation
        return out + d * std::clamp(t, 0.0, 1.0);
    };
    ConvexPiece left;
    for (int i = 0; i < piece.count; ++i) {
        const int j = i + 1 < piece.count ? i + 1 : 0;
        const double at_i = excess[static_cast<std::size_t>(i)];
        const double at_j = excess[static_cast<std::size_t>(j)];
        if (at_i >= 0)
            left.add(piece[i]);
        if (at_i >= 0 && at_j < 0)
            left.add(crossing(piece[i], at_i, piece[j]));
        else if (at_i < 0 && at_j >= 0)
            left.add(crossing(piece[j], at_j, piece[i]));
    }
    piece = left;
    return true;
}

} // namespace scree
