// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/figures/no_fit.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

constexpr float never_near = 1e30F; // the offset of a half-plane that holds everything

} // namespace

NoFitPiece::NoFitPiece(const Ring& ring, double corner) : vertices(ring) {
    const Box2 box = bounds({.rings = {ring}, .vertices = {}, .triangles = {}});
    centre = box.center();
    for (const Vec2& v : ring)
        radius = std::max(radius, (v - centre).length());
    double widest = 0;
    const std::size_t n = ring.size();
    const auto normal = [&](std::size_t i) {
        const Vec2 along = ring[(i + 1) % n] - ring[i % n];
        return Vec2(along.y, -along.x).normalized();
    };
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 here = normal(i), next = normal(i + 1);
        normals.push_back(here);
        offsets.push_back(here.dot(ring[i]));
        const double gap = std::atan2(cross(here, next), here.dot(next));
        const int steps = static_cast<int>(std::ceil(gap / corner - 1e-6));
        for (int k = 1; k < steps; ++k) {
            normals.push_back(rotate(here, gap * k / steps));
            offsets.push_back(normals.back().dot(ring[(i + 1) % n]));
        }
        widest = std::max(widest, gap / std::max(1, steps));
    }
    corner_cosine = std::cos(widest / 2);
}

bool NoFitPiece::is_near(const Vec2& point, double distance) const {
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (normals[i].dot(point) > offsets[i] + distance)
            return false;
    return true;
}

void PiecePool::clear() {
    pieces_.clear();
    normal_x_.clear();
    normal_y_.clear();
    offset_.clear();
    vertices_.clear();
}

void PiecePool::add(const NoFitPiece& piece, double cosine, double sine, double scale,
                    const Vec2& position) {
    const auto turn = [&](const Vec2& v) {
        return Vec2(cosine * v.x - sine * v.y, sine * v.x + cosine * v.y);
    };
    const Vec2 centre = turn(piece.centre) * scale + position;
    pieces_.push_back({.first_quad = static_cast<std::uint32_t>(normal_x_.size()),
                       .quads = static_cast<std::uint32_t>((piece.normals.size() + 3) / 4),
                       .first_vertex = static_cast<std::uint32_t>(vertices_.size()),
                       .vertices = static_cast<std::uint32_t>(piece.vertices.size()),
                       .centre = Vec2f(centre),
                       .radius = static_cast<float>(piece.radius * scale),
                       .corner_cosine = static_cast<float>(piece.corner_cosine)});
    for (std::size_t i = 0; i < piece.normals.size(); ++i) {
        if (i % 4 == 0) {
            normal_x_.push_back(Float4{});
            normal_y_.push_back(Float4{});
            offset_.push_back(Float4{} + never_near);
        }
        const Vec2 normal = turn(piece.normals[i]);
        normal_x_.back()[i % 4] = static_cast<float>(normal.x);
        normal_y_.back()[i % 4] = static_cast<float>(normal.y);
        offset_.back()[i % 4] = static_cast<float>(piece.offsets[i] * scale + normal.dot(position));
    }
    for (const Vec2& v : piece.vertices)
        vertices_.emplace_back(turn(v) * scale + position);
}

void HalfPlanes::clear() {
    normal_x.clear();
    normal_y.clear();
    offset.clear();
}

NoFit no_fit(const PiecePool& moving, const PiecePool::Piece& a, const TurnInterval& turn,
             const PiecePool& fixed, const PiecePool::Piece& b, float clearance,
             float largest_clearance, const Imath::Box2f& box, HalfPlanes& result) {
    result.clear();
    bool is_here = true;
    const Vec2f centre = box.center(), half = box.size() * 0.5F;
    // Across the fixed piece's edges: the moving piece reaches towards the edge at least as far as
    // any one of its vertices does at every angle; the best vertex counts. A vertex at distance m
    // along the inward normal and t across it is, turned by p, at m cos(p) - t sin(p).
    const Vec2f* const va = moving.vertices(a);
    for (std::uint32_t q = 0; q < b.quads; ++q) {
        const Float4 nx = fixed.normal_x(b)[q], ny = fixed.normal_y(b)[q];
        Float4 reach = Float4{} - never_near, most = reach;
        for (std::uint32_t i = 0; i < a.vertices; ++i) {
            const Float4 m = -(nx * va[i].x + ny * va[i].y);
            const Float4 t = nx * va[i].y - ny * va[i].x;
            const Float4 change = absolute(m) * (1 - turn.cosine) + absolute(t) * turn.sine;
            const Float4 least = m - change, greatest = m + change;
            reach = maximum(reach, minimum(least * turn.low, least * turn.high));
            most = maximum(most, maximum(greatest * turn.low, greatest * turn.high));
        }
        const Float4 offset = fixed.offset(b)[q];
        const Float4 nearest =
            nx * centre.x + ny * centre.y - absolute(nx) * half.x - absolute(ny) * half.y - offset;
        if (any(nearest > most + largest_clearance))
            return NoFit::never;
        is_here = is_here && !any(nearest > reach + clearance);
        result.normal_x.push_back(nx);
        result.normal_y.push_back(ny);
        result.offset.push_back(offset + reach + clearance);
    }
    // Across the moving piece's edges, whose normals turn: one vertex w of the fixed piece must be
    // inside the edge at every angle. With y = x - w, -n(p) . y <= h at both ends of the interval
    // with h cos(half) in place of h implies it between them, where n(p) is a combination of the
    // two with coefficients that add up to at most 1 / cos(half), and to at least 1. The best w is
    // that for which both hold farthest at the middle of the box.
    const Vec2f* const vb = fixed.vertices(b);
    const float swing = turn.sine * ((centre - b.centre).length() + b.radius + half.length());
    for (std::uint32_t q = 0; q < a.quads; ++q) {
        const Float4 nx = moving.normal_x(a)[q], ny = moving.normal_y(a)[q];
        Float4 best = Float4{} - never_near, wx{}, wy{};
        Float4 nearest = Float4{} + never_near;
        for (std::uint32_t i = 0; i < b.vertices; ++i) {
            const float dx = vb[i].x - centre.x, dy = vb[i].y - centre.y;
            const Float4 along = nx * dx + ny * dy, across = absolute(ny * dx - nx * dy);
            const Float4 merit = -(along * turn.cosine + across * turn.sine);
            const Mask4 better = merit > best;
            best = better ? merit : best;
            wx = better ? Float4{} + vb[i].x : wx;
            wy = better ? Float4{} + vb[i].y : wy;
            nearest = minimum(nearest, along);
        }
        const Float4 h0 = moving.offset(a)[q];
        const Float4 low = h0 * turn.low, high = h0 * turn.high;
        if (any(nearest - absolute(nx) * half.x - absolute(ny) * half.y - swing >
                maximum(low, high) + largest_clearance))
            return NoFit::never;
        const Float4 h = minimum(low, high) + clearance;
        const Float4 inset = minimum(h, h * turn.cosine);
        for (const float sine : {-turn.sine, turn.sine}) {
            const Float4 x = nx * turn.cosine - ny * sine, y = nx * sine + ny * turn.cosine;
            const Float4 offset = inset - (x * wx + y * wy);
            is_here = is_here && !any(-(x * centre.x + y * centre.y) - absolute(x) * half.x -
                                          absolute(y) * half.y >
                                      offset);
            result.normal_x.push_back(-x);
            result.normal_y.push_back(-y);
            result.offset.push_back(offset);
        }
    }
    return is_here ? NoFit::found : NoFit::not_here;
}

} // namespace scree
