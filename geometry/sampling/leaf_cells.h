// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/sampling/disk_metric.h"
#include "geometry/sampling/domain_cells.h"

#include <optional>
#include <span>

namespace scree {

/// A problem's domain divided into cells of about the size of the disks there: a grid of roots,
/// each quartered as often as the scale requires. Cells are numbered root by root, so that the
/// cells of neighbouring roots of a row have consecutive numbers.
class LeafCells {
  public:
    LeafCells(const PoissonDiskProblem& problem, const DiskMetric& metric);

    std::uint32_t count() const { return static_cast<std::uint32_t>(leaves_.size()); }
    Box2 box(std::uint32_t leaf) const {
        const Leaf& l = leaves_[leaf];
        return {l.corner, l.corner + size(leaf)};
    }

    Vec2 size(std::uint32_t leaf) const { return grid_.cell * double(leaves_[leaf].share); }

    ConvexPiece square(std::uint32_t leaf) const;

    /// Whether new samples are looked for in all of the cell.
    bool is_whole(std::uint32_t leaf) const { return leaves_[leaf].is_whole; }

    /// The longest semi-axis of samples in the cell [m].
    double reach(std::uint32_t leaf) const { return double(leaves_[leaf].reach); }

    /// The parts of a cell that is not whole in which new samples are looked for.
    std::span<const ConvexPiece> pieces(std::uint32_t leaf) const;
    void forget_pieces() { pieces_ = {}; }

    std::optional<std::uint32_t> leaf_at(const Vec2& point) const;

    /// visit(first, last) for runs of cells, among them all whose samples may conflict with samples
    /// of this cell, and itself.
    template <class Visit>
    void for_runs_near(std::uint32_t leaf, const Visit& visit) const {
        const Leaf& l = leaves_[leaf];
        for_runs(l.first_column, l.last_column, l.first_row, l.last_row, visit);
    }

    /// The shortest of a vector's images on a torus.
    Vec2 nearest_image(const Vec2& v) const {
        if (!torus_)
            return v;
        return {v.x - std::round(v.x / period_.x) * period_.x,
                v.y - std::round(v.y / period_.y) * period_.y};
    }

  private:
    struct Leaf {
        Vec2 corner;
        float share = 1;      // of its root's sides
        float reach = 0;      // [m]
        int first_column = 0; // of the roots whose cells may matter; on a torus these may lie
        int last_column = 0;  // beyond the grid's ends
        int first_row = 0;
        int last_row = 0;
        bool is_whole = false;
    };

    template <class Visit>
    void for_runs(int c0, int c1, int r0, int r1, const Visit& visit) const {
        const auto run = [&](int row, int from, int to) {
            const std::size_t at = std::size_t(row) * std::size_t(grid_.columns);
            visit(first_leaf_[at + std::size_t(from)], first_leaf_[at + std::size_t(to) + 1]);
        };
        if (!torus_) {
            for (int row = r0; row <= r1; ++row)
                run(row, c0, c1);
            return;
        }
        const int columns = grid_.columns;
        const bool all = c1 - c0 + 1 >= columns;
        for (int row = r0; row <= std::min(r1, r0 + grid_.rows - 1); ++row) {
            const int r = (row % grid_.rows + grid_.rows) % grid_.rows;
            if (all || (c0 >= 0 && c1 < columns)) {
                run(r, all ? 0 : c0, all ? columns - 1 : c1);
            } else if (c0 < 0) {
                run(r, c0 + columns, columns - 1);
                run(r, 0, c1);
            } else {
                run(r, c0, columns - 1);
                run(r, 0, c1 - columns);
            }
        }
    }

    void make_grid(const PoissonDiskProblem& problem, const DiskMetric& metric);
    void add_leaves(const Leaf& leaf, std::vector<ConvexPiece> pieces, const DiskMetric& metric);
    void set_neighbours();
    void set_neighbours(Leaf& leaf, double distance) const;

    CellGrid grid_;
    bool torus_;
    Vec2 period_{0, 0};
    std::vector<std::uint32_t> first_leaf_; // of each root, and one past the last
    std::vector<Leaf> leaves_;
    std::vector<std::uint32_t> first_piece_;
    std::vector<ConvexPiece> pieces_;
};

} // namespace scree
