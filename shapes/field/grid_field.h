// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/field.h"

#include <vector>

namespace scree {

/// Samples on a regular grid of the ground plane, row by row: sample (column, row) stands at
/// first + (column, row) * step.
struct SampleGrid {
    int columns = 1; // at least 1
    int rows = 1;
    Vec2 first{0.0};             // [m]
    Vec2 step{1.0};              // [m], positive
    std::vector<float> values{}; // columns * rows, finite
    bool torus = false;          // repeats itself instead of ending at its border
    bool angle = false;          // degrees: between two samples the field turns the shorter way
    bool stepped = false;        // the nearest sample's value instead of a mixture: for classes
};

/// A grid interpolated bilinearly. Outside a grid that is no torus, the nearest border's values
/// go on. An angle field jumps in cells around which it makes a full turn, and only there.
class GridField final : public Field {
  public:
    explicit GridField(SampleGrid grid);

    double at(const Vec2& point) const override; // an angle lies in [0, 360)

    /// Exact but for rounding over up to 8 x 8 cells; over larger boxes from a pyramid of the
    /// ranges of blocks of cells, of which a box meets at most 5 x 5.
    Range over(const Box2& box) const override;

    double period() const override { return grid_.angle ? 360 : 0; }

  private:
    /// A place on one axis, in cells.
    struct Position {
        int cell = 0;
        double share = 0; // of the cell, in [0, 1]
    };
    /// What a box covers of one axis; on a torus `to` may lie beyond the last cell.
    struct Span {
        Position from;
        Position to;
        int count() const { return to.cell - from.cell + 1; }
    };
    /// Ranges of square blocks of cells.
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
