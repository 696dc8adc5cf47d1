// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/surface_cells.h"

#include "core/parallel.h"

#include <algorithm>
#include <compare>
#include <functional>
#include <limits>

namespace scree {

namespace {

// Keeps the part of a piece where `axis` of space lies between two values.
void keep_slab(ConvexPiece& piece, const TrianglePlane& plane, unsigned axis, double low,
               double high) {
    // In the plane the coordinate is a linear function with this gradient.
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

void SurfaceCells::Pieces::add(const Key& key, std::uint32_t triangle, const ConvexPiece& piece) {
    keys.push_back(key);
    triangles.push_back(triangle);
    corners.insert(corners.end(), piece.corner.begin(), piece.corner.begin() + piece.count);
    first_corner.push_back(static_cast<std::uint32_t>(corners.size()));
}

void SurfaceCells::Pieces::add(const Pieces& others) {
    const auto before = static_cast<std::uint32_t>(corners.size());
    keys.insert(keys.end(), others.keys.begin(), others.keys.end());
    triangles.insert(triangles.end(), others.triangles.begin(), others.triangles.end());
    for (std::size_t i = 1; i < others.first_corner.size(); ++i)
        first_corner.push_back(before + others.first_corner[i]);
    corners.insert(corners.end(), others.corners.begin(), others.corners.end());
}

SurfacePiece SurfaceCells::Pieces::at(std::uint32_t i) const {
    SurfacePiece piece;
    piece.triangle = triangles[i];
    for (std::uint32_t c = first_corner[i]; c < first_corner[i + 1]; ++c)
        piece.piece.add(corners[c]);
    return piece;
}

SurfaceCells::SurfaceCells(const Mesh& mesh, double side) : side_(side) {
    const Box3 box = bounds(mesh);
    origin_ = Imath::V3d(box.min) - Imath::V3d(side / 2);
    planes_.resize(mesh.triangles.size());
    cut_triangles(mesh);
    sort_pieces();
    find_near();
}

void SurfaceCells::cut_triangles(const Mesh& mesh) {
    constexpr std::size_t chunk = 4096;
    std::vector<Pieces> chunks((mesh.triangles.size() + chunk - 1) / chunk);
    parallel_for(chunks.size(), 1, [&](std::size_t k) {
        const std::size_t end = std::min((k + 1) * chunk, mesh.triangles.size());
        for (std::size_t t = k * chunk; t < end; ++t) {
            std::array<Imath::V3d, 3> corners;
            for (std::size_t i = 0; i < 3; ++i)
                corners[i] = Imath::V3d(mesh.positions[mesh.triangles[t][i]]) - origin_;
            cut_triangle(static_cast<std::uint32_t>(t), corners, chunks[k]);
            planes_[t].origin += origin_;
        }
    });
    for (Pieces& part : chunks) {
        pieces_.add(part);
        part = {};
    }
}

// Cuts slab by slab along each axis in turn.
void SurfaceCells::cut_triangle(std::uint32_t triangle, const std::array<Imath::V3d, 3>& corners,
                                Pieces& pieces) {
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
        if (area(whole) > 0)
            pieces.add(key, triangle, whole);
        return;
    }
    const auto cut = [&](const auto& self, const ConvexPiece& piece, unsigned axis,
                         Key key) -> void {
        if (axis == 3) {
            if (area(piece) > 0)
                pieces.add(key, triangle, piece);
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
    // By key, then as they come, in two numbers: no key is negative.
    struct Entry {
        std::uint64_t xy, z_and_number;
        auto operator<=>(const Entry&) const = default;
    };
    std::vector<Entry> entries(pieces_.keys.size());
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
        const Key& key = pieces_.keys[i];
        entries[i] = {std::uint64_t(key[0]) << 32 | std::uint64_t(key[1]),
                      std::uint64_t(key[2]) << 32 | i};
    }
    parallel_sort(entries.begin(), entries.end(), std::less<>());
    order_.reserve(entries.size());
    for (const Entry& entry : entries) {
        const auto i = static_cast<std::uint32_t>(entry.z_and_number);
        if (keys_.empty() || keys_.back() != pieces_.keys[i]) {
            keys_.push_back(pieces_.keys[i]);
            first_piece_.push_back(static_cast<std::uint32_t>(order_.size()));
        }
        order_.push_back(i);
    }
    first_piece_.push_back(static_cast<std::uint32_t>(order_.size()));
    pieces_.keys = {};
}

void SurfaceCells::find_near() {
    // Three cells one above the other follow each other. The lowest of each three moves up through
    // the keys as the cell in the middle does.
    std::array<std::size_t, 9> lowest{};
    for (const Key& key : keys_) {
        first_near_.push_back(static_cast<std::uint32_t>(near_.size()));
        for (std::size_t column = 0; column < 9; ++column) {
            const Key low{key[0] + static_cast<int>(column / 3) - 1,
                          key[1] + static_cast<int>(column % 3) - 1, key[2] - 1};
            while (lowest[column] < keys_.size() && keys_[lowest[column]] < low)
                ++lowest[column];
            for (std::size_t i = lowest[column]; i < keys_.size() && keys_[i][0] == low[0] &&
                                                 keys_[i][1] == low[1] && keys_[i][2] <= key[2] + 1;
                 ++i)
                near_.push_back(static_cast<std::uint32_t>(i));
        }
    }
    first_near_.push_back(static_cast<std::uint32_t>(near_.size()));
}

} // namespace scree
