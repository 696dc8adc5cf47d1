// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/field/grid_field.h"

#include "shapes/field/range_union.h"

#include <array>
#include <cassert>

namespace scree {

namespace {

constexpr int max_cells = 8;      // per axis; a box over more cells uses the pyramid
constexpr int smallest_block = 4; // [cells]
constexpr int max_blocks = 4;     // per axis, if the box is aligned to them

/// The field inside one cell, from its samples at (0, 0), (1, 0), (0, 1) and (1, 1). Interpolated
/// along x, then along z; angles by the shorter turn in both steps. Neighbouring cells agree on
/// their common side, where only the two samples of that side have weight.
struct Cell {
    double a, b, c, d;
    bool angle, stepped;

    double difference(double from, double to) const {
        return angle ? shorter_turn(to - from) : to - from;
    }
    double near_side(double s) const { return a + s * difference(a, b); }
    double far_side(double s) const { return c + s * difference(c, d); }

    double nearest(bool right, bool below) const {
        return below ? (right ? d : c) : (right ? b : a);
    }

    double at(double s, double t) const {
        if (stepped)
            return nearest(s >= 0.5, t >= 0.5);
        const double low = near_side(s);
        return low + t * difference(low, far_side(s));
    }

    /// The range over [s0, s1] x [t0, t1]. A bilinear function has its extremes at the corners.
    Range over(double s0, double s1, double t0, double t1) const {
        if (stepped) {
            const auto [low, high] =
                std::minmax({nearest(s0 >= 0.5, t0 >= 0.5), nearest(s1 >= 0.5, t0 >= 0.5),
                             nearest(s0 >= 0.5, t1 >= 0.5), nearest(s1 >= 0.5, t1 >= 0.5)});
            return {low, high};
        }
        const double low0 = near_side(s0), low1 = near_side(s1);
        double rise0 = far_side(s0) - low0, rise1 = far_side(s1) - low1;
        if (angle) {
            const double turns = full_turns(rise0);
            if (turns != full_turns(rise1)) // the shorter turn changes direction: a jump
                return {0, 360};
            rise0 -= 360 * turns;
            rise1 -= 360 * turns;
        }
        const auto [low, high] = std::minmax(
            {low0 + t0 * rise0, low0 + t1 * rise0, low1 + t0 * rise1, low1 + t1 * rise1});
        return {low, high};
    }
};

Cell cell_of(const SampleGrid& grid, int column, int row) {
    const auto next = [&](int i, int count) {
        return i + 1 < count ? i + 1 : grid.torus ? 0 : count - 1;
    };
    const auto value = [&](int x, int z) {
        return double{grid.values[std::size_t(z) * std::size_t(grid.columns) + std::size_t(x)]};
    };
    const int right = next(column, grid.columns);
    const int below = next(row, grid.rows);
    return {value(column, row),  value(right, row), value(column, below),
            value(right, below), grid.angle,        grid.stepped};
}

} // namespace

GridField::GridField(SampleGrid grid) : grid_(std::move(grid)) {
    assert(grid_.values.size() == std::size_t(grid_.columns) * std::size_t(grid_.rows));
    build_levels();
}

int GridField::cells(unsigned axis) const {
    const int samples = axis == 0 ? grid_.columns : grid_.rows;
    return grid_.torus ? samples : std::max(1, samples - 1);
}

GridField::Position GridField::position(double coordinate, unsigned axis) const {
    const double along = (coordinate - grid_.first[axis]) / grid_.step[axis];
    const int count = cells(axis);
    if (grid_.torus) {
        const double whole = std::floor(along);
        const double wrapped = whole - count * std::floor(whole / count);
        return {std::min(static_cast<int>(wrapped), count - 1), along - whole};
    }
    const double inside = std::clamp(along, 0.0, static_cast<double>(count));
    const int cell = std::min(static_cast<int>(inside), count - 1);
    return {cell, inside - cell};
}

GridField::Span GridField::span(const Box2& box, unsigned axis) const {
    const int count = cells(axis);
    if (!grid_.torus)
        return {position(box.min[axis], axis), position(box.max[axis], axis)};
    const auto cell_number = [&](double coordinate) {
        return std::floor((coordinate - grid_.first[axis]) / grid_.step[axis]);
    };
    const double length = cell_number(box.max[axis]) - cell_number(box.min[axis]);
    if (!(length < count)) // the whole period, or not a number
        return {{0, 0}, {count - 1, 1}};
    Span out{position(box.min[axis], axis), position(box.max[axis], axis)};
    out.to.cell = out.from.cell + static_cast<int>(length);
    return out;
}

double GridField::at(const Vec2& point) const {
    const Position x = position(point.x, 0);
    const Position z = position(point.y, 1);
    const double value = cell_of(grid_, x.cell, z.cell).at(x.share, z.share);
    return grid_.angle ? positive_angle(value) : value;
}

Range GridField::over(const Box2& box) const {
    const Span x = span(box, 0);
    const Span z = span(box, 1);
    const bool few = std::max(x.count(), z.count()) <= max_cells;
    return few ? over_cells(x, z) : over_blocks(x, z);
}

Range GridField::over_cells(const Span& x, const Span& z) const {
    RangeUnion all(grid_.angle);
    for (int row = z.from.cell; row <= z.to.cell; ++row) {
        const double t0 = row == z.from.cell ? z.from.share : 0;
        const double t1 = row == z.to.cell ? z.to.share : 1;
        for (int column = x.from.cell; column <= x.to.cell; ++column) {
            const double s0 = column == x.from.cell ? x.from.share : 0;
            const double s1 = column == x.to.cell ? x.to.share : 1;
            all.add(cell_of(grid_, column % cells(0), row % cells(1)).over(s0, s1, t0, t1));
        }
    }
    return all.range();
}

Range GridField::over_blocks(const Span& x, const Span& z) const {
    std::size_t index = 0;
    while (index + 1 < levels_.size() &&
           std::max(x.count(), z.count()) > max_blocks * levels_[index].block)
        ++index;
    const Level& level = levels_[index];
    // The first and last block of a span; a second run where it wraps around a torus.
    const auto runs = [&](const Span& span, unsigned axis) {
        const int last = cells(axis) - 1;
        std::array<std::array<int, 2>, 2> out{
            {{span.from.cell / level.block, std::min(span.to.cell, last) / level.block}, {0, -1}}};
        if (span.to.cell > last)
            out[1][1] = (span.to.cell - last - 1) / level.block;
        return out;
    };
    RangeUnion all(grid_.angle);
    for (const auto& [first_row, last_row] : runs(z, 1))
        for (const auto& [first_column, last_column] : runs(x, 0))
            for (int row = first_row; row <= last_row; ++row)
                for (int column = first_column; column <= last_column; ++column)
                    all.add(level.ranges[std::size_t(row) * std::size_t(level.columns) +
                                         std::size_t(column)]);
    return all.range();
}

void GridField::build_levels() {
    if (std::max(cells(0), cells(1)) <= max_cells)
        return;
    for (int block = smallest_block;; block *= 2) {
        Level level{block, (cells(0) + block - 1) / block, (cells(1) + block - 1) / block, {}};
        level.ranges.reserve(std::size_t(level.columns) * std::size_t(level.rows));
        // The lowest level combines cells, every other one 2 x 2 blocks of the level below.
        const Level* below = levels_.empty() ? nullptr : &levels_.back();
        const int part = below == nullptr ? block : 2;
        const int columns = below == nullptr ? cells(0) : below->columns;
        const int rows = below == nullptr ? cells(1) : below->rows;
        for (int z = 0; z < level.rows; ++z) {
            for (int x = 0; x < level.columns; ++x) {
                RangeUnion all(grid_.angle);
                for (int row = z * part; row < std::min(rows, (z + 1) * part); ++row)
                    for (int column = x * part; column < std::min(columns, (x + 1) * part);
                         ++column)
                        all.add(below == nullptr
                                    ? cell_of(grid_, column, row).over(0, 1, 0, 1)
                                    : below->ranges[std::size_t(row) * std::size_t(below->columns) +
                                                    std::size_t(column)]);
                level.ranges.push_back(all.range());
            }
        }
        levels_.push_back(std::move(level));
        if (levels_.back().ranges.size() == 1)
            return;
    }
}

} // namespace scree
