// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/plane/convex_piece.h"

#include <array>
#include <span>

namespace scree {

/// The plane of a triangle with axes of length 1; coordinates in it are metres from its first
/// corner.
struct TrianglePlane {
    Imath::V3d origin;
    Imath::V3d x_axis;
    Imath::V3d y_axis;
    Imath::V3d normal;

    Vec2 project(const Imath::V3d& p) const {
        return {(p - origin).dot(x_axis), (p - origin).dot(y_axis)};
    }
    Imath::V3d at(const Vec2& p) const { return origin + x_axis * p.x + y_axis * p.y; }
    double height(const Imath::V3d& p) const { return (p - origin).dot(normal); }
};

/// The part of one triangle in one cell.
struct SurfacePiece {
    std::uint32_t triangle = 0;
    ConvexPiece piece; // in the triangle's plane
};

/// A mesh cut by a grid of cubes, of which only those that meet it exist.
class SurfaceCells {
  public:
    /// `side` [m] of a cube. Triangles without area are left out.
    SurfaceCells(const Mesh& mesh, double side);

    std::uint32_t count() const { return static_cast<std::uint32_t>(keys_.size()); }
    std::size_t piece_count() const { return order_.size(); }

    /// Calls found(piece) for each piece in the cell.
    template <class Found>
    void each_piece(std::uint32_t cell, const Found& found) const {
        for (std::uint32_t i = first_piece_[cell]; i < first_piece_[cell + 1]; ++i)
            found(pieces_.at(order_[i]));
    }

    /// The cells of the 27 cubes around, itself among them.
    std::span<const std::uint32_t> near(std::uint32_t cell) const {
        return {near_.data() + first_near_[cell], first_near_[cell + 1] - first_near_[cell]};
    }

    const TrianglePlane& plane(std::uint32_t triangle) const { return planes_[triangle]; }

  private:
    using Key = std::array<std::int32_t, 3>;

    /// Pieces with no more memory than they have corners: there are many, most of them triangles.
    struct Pieces {
        std::vector<Key> keys; // of the pieces' cells
        std::vector<std::uint32_t> triangles;
        std::vector<std::uint32_t> first_corner{0}; // and the end
        std::vector<Vec2> corners;

        void add(const Key& key, std::uint32_t triangle, const ConvexPiece& piece);
        void add(const Pieces& others);
        SurfacePiece at(std::uint32_t i) const;
    };

    void cut_triangles(const Mesh& mesh);
    void cut_triangle(std::uint32_t triangle, const std::array<Imath::V3d, 3>& corners,
                      Pieces& pieces);
    void sort_pieces();
    void find_near();

    double side_;
    Imath::V3d origin_;
    std::vector<TrianglePlane> planes_;
    Pieces pieces_;
    std::vector<std::uint32_t> order_; // of the pieces, cell by cell
    std::vector<Key> keys_;            // of the cells, ascending
    std::vector<std::uint32_t> first_piece_;
    std::vector<std::uint32_t> near_;
    std::vector<std::uint32_t> first_near_;
};

} // namespace scree
