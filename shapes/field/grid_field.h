// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/field.h"

#include <vector>

namespace scree {

/// Samples on a regular grid in the ground plane, row by row: sample (column, row) lies at
/// first + (column, row) * step.
struct SampleGrid {
    int columns = 1; // at least 1
    int rows = 1;
    Vec2 first{0.0};             // [m]
    Vec2 step{1.0};              // [m], positive
    std::vector<float> values{}; // columns * rows, finite
    bool torus = false;          // periodic; otherwise extended by the border's values
    bool angle = false;          // values are degrees, interpolated by the shorter turn
    bool stepped = false;        // nearest sample instead of interpolation: for class numbers
};

/// A bilinearly interpolated grid. Outside a grid that is not a torus, points are clamped to the
/// border. An angle field is discontinuous only in cells around which it makes a full turn.
class GridField final : public Field {
  public:
    explicit GridField(SampleGrid grid);

    double at(const Vec2& point) const override; // an angle lies in [0, 360)

    /// Exact up to rounding for a box over at most 8 x 8 cells. A larger box gets a conservative
    /// range from a pyramid of blocks of cells, of which it meets at most 5 x 5.
    Range over(const Box2& box) const override;

    double period() const override { return grid_.angle ? 360 : 0; }

  private:
    /// A position along one axis.
    struct Position {
        int cell = 0;
        double share = 0; // of the cell, in [0, 1]
    };
    /// The part of one axis that a box covers; on a torus `to` may lie beyond the last cell.
    struct Span {
        Position from;
        Position to;
        int count() const { return to.cell - from.cell + 1; }
    };
    /// A level of the pyramid: the ranges of square blocks of cells.
    struct Level {
        int block = 1; // cells along a side
        int columns = 0;
        int rows = 0;
        std::vector<Range> ranges;
    };

    Position position(double coordinate, unsigned axis) const;
    Span span(const Box2& box, unsigned axis) const;
    int cells(unsigned axis) const;
    Range over_cells(const Span& x, const Span& z) const;
    Range over_blocks(const Span& x, const Span& z) const;
    void build_levels();

    SampleGrid grid_;
    std::vector<Level> levels_;
};

} // namespace scree
