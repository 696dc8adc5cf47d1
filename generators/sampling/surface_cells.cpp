// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/sampling/surface_cells.h"

#include "core/parallel.h"

#include <functional>

namespace scree {

namespace {

// Keeps the part of a piece where `axis` of space lies between two values.
void keep_slab(ConvexPiece& piece, const TrianglePlane& plane, unsigned axis, double low,
               double high) {
    // Along the plane the coordinate is a linear function: its gradient, and a
    // line across it.
    const Vec2 gradient(plane.x_axis[int(axis)], plane.y_axis[int(axis)]);
    const double at_origin = plane.origin[int(axis)];
    const double length2 = gradient.length2();
    if (length2 < 1e-24) { // parallel to the slab
        if (at_origin < low || at_origin >= high)
            piece.count = 0;
        return;
    }
    const Vec2 across(gradient.y, -gradient.x); // what is larger lies on its left
    keep_left(piece, gradient * ((low - at_origin) / length2), across);
    keep_left(piece, gradient * ((high - at_origin) / length2), -across);
}

struct Span {
    double low = 0;
    double high = 0;
};

Span extent(const ConvexPiece& piece, const TrianglePlane& plane, unsigned axis) {
    Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int i = 0; i < piece.count; ++i) {
        const double v = plane.at(piece[i])[int(axis)];
        span = {std::min(span.low, v), std::max(span.high, v)};
    }
    return span;
}

} // namespace

SurfaceCells::SurfaceCells(const Mesh& mesh, double side) : side_(side) {
    const Box3 box = bounds(mesh);
    origin_ = Imath::V3d(box.min) - Imath::V3d(side / 2);
    planes_.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<Imath::V3d, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = Imath::V3d(mesh.positions[mesh.triangles[t][i]]) - origin_;
        cut_triangle(t, corners);
        planes_[t].origin += origin_;
    }
    sort_pieces();
    find_near();
}

// Slab by slab along each axis in turn.
void SurfaceCells::cut_triangle(std::uint32_t triangle, const std::array<Imath::V3d, 3>& corners) {
    TrianglePlane& plane = planes_[triangle];
    plane.origin = corners[0];
    const Imath::V3d a = corners[1] - corners[0];
    const Imath::V3d b = corners[2] - corners[0];
    plane.normal = a.cross(b);
    const double twice_area = plane.normal.length();
    if (!(twice_area > 1e-18 * std::max(a.length2(), b.length2())))
        return;
    plane.normal /= twice_area;
    plane.x_axis = a.normalized();
    plane.y_axis = plane.normal.cross(plane.x_axis);
    ConvexPiece whole;
    for (const Imath::V3d& corner : corners)
        whole.add(plane.project(corner));
    const auto cell = [&](double v) { return static_cast<std::int32_t>(std::floor(v / side_)); };
    // Of a fine mesh most triangles lie in one cell.
    const auto cell_of = [&](const Imath::V3d& p) { return Key{cell(p.x), cell(p.y), cell(p.z)}; };
    if (const Key key = cell_of(corners[0]);
        key == cell_of(corners[1]) && key == cell_of(corners[2])) {
        if (area(whole) > 0) {
            keys_.push_back(key);
            pieces_.push_back({triangle, whole});
        }
        return;
    }
    const auto cut = [&](const auto& self, const ConvexPiece& piece, unsigned axis,
                         Key key) -> void {
        if (axis == 3) {
            if (area(piece) > 0) {
                keys_.push_back(key);
                pieces_.push_back({triangle, piece});
            }
            return;
        }
        const Span span = extent(piece, plane, axis);
        for (std::int32_t i = cell(span.low); i <= cell(span.high); ++i) {
            ConvexPiece part = piece;
            if (cell(span.low) != cell(span.high))
                keep_slab(part, plane, axis, i * side_, (i + 1) * side_);
            key[axis] = i;
            if (part.count >= 3)
                self(self, part, axis + 1, key);
        }
    };
    cut(cut, whole, 0, {});
}

void SurfaceCells::sort_pieces() {
    std::vector<std::pair<Key, std::uint32_t>> order(pieces_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        order[i] = {keys_[i], i};
    parallel_sort(order.begin(), order.end(), std::less<>());
    std::vector<Key> keys;
    std::vector<SurfacePiece> pieces;
    pieces.reserve(order.size());
    for (const auto& [key, i] : order) {
        if (keys.empty() || keys.back() != key) {
            keys.push_back(key);
            first_piece_.push_back(static_cast<std::uint32_t>(pieces.size()));
        }
        pieces.push_back(pieces_[i]);
    }
    first_piece_.push_back(static_cast<std::uint32_t>(pieces.size()));
    keys_ = std::move(keys);
    pieces_ = std::move(pieces);
}

void SurfaceCells::find_near() {
    for (const Key& key : keys_) {
        first_near_.push_back(static_cast<std::uint32_t>(near_.size()));
        for (std::int32_t x = -1; x <= 1; ++x)
            for (std::int32_t y = -1; y <= 1; ++y) {
                // Three cells one above the other follow each other.
                const Key low{key[0] + x, key[1] + y, key[2] - 1};
                auto it = std::lower_bound(keys_.begin(), keys_.end(), low);
                for (; it != keys_.end() && (*it)[0] == low[0] && (*it)[1] == low[1] &&
                       (*it)[2] <= key[2] + 1;
                     ++it)
                    near_.push_back(static_cast<std::uint32_t>(it - keys_.begin()));
            }
    }
    first_near_.push_back(static_cast<std::uint32_t>(near_.size()));
}

} // namespace scree
