// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/convex_piece.h"
#include "geometry/plane/region.h"

#include <span>

namespace scree {

/// Equal rectangles side by side, row by row.
struct CellGrid {
    Vec2 origin{0, 0};
    Vec2 cell{1, 1};
    int columns = 0;
    int rows = 0;

    std::size_t size() const { return std::size_t(columns) * std::size_t(rows); }
    Vec2 corner(int column, int row) const { return origin + Vec2(column, row) * cell; }
};

/// A grid of squares of `side` [m] that contains the box; with `fit`, of rectangles that are no
/// larger and fill the box exactly.
CellGrid grid_over(const Box2& box, double side, bool fit);

/// Which cells of a grid lie in a region. What crosses a cell that the region's border crosses is
/// cut out of the region's triangulation exactly, up to rounding (the boundary and inner cells of
/// Kita & Miyata 2012, section 3.1; what the flood fill finds there the triangles give here).
class DomainCells {
  public:
    enum class Kind : std::uint8_t { outside, inside, border };

    DomainCells(const Region& region, const CellGrid& grid);

    Kind kind(std::size_t cell) const { return kinds_[cell]; }

    /// The parts of a border cell that lie in the region, from the region's frame moved so that
    /// the cell's corner is the origin.
    std::span<const ConvexPiece> parts(std::size_t cell) const;

  private:
    void mark_edge(const Vec2& a, const Vec2& b);
    void add_triangle(const ConvexPiece& triangle);

    CellGrid grid_;
    std::vector<Kind> kinds_;
    std::vector<std::uint32_t> owner_; // of parts_, ascending
    std::vector<ConvexPiece> parts_;
};

} // namespace scree
