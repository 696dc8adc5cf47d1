// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/leaf_cells.h"

#include "core/error.h"

#include <fmt/format.h>

#include <limits>

namespace scree {

namespace {

constexpr double max_roots = 0x1p28;

// The side of a cell in which a disk of this distance leaves no room for a second one.
double side_for(double distance) { return distance / std::numbers::sqrt2; }

void keep_box(ConvexPiece& piece, const Box2& box) {
    keep_left(piece, box.min, {1, 0});
    keep_left(piece, box.max, {-1, 0});
    keep_left(piece, box.min, {0, -1});
    keep_left(piece, box.max, {0, 1});
}

ConvexPiece square_at(const Vec2& corner, const Vec2& size) {
    ConvexPiece piece;
    for (const Vec2& at : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
        piece.add(corner + at * size);
    return piece;
}

} // namespace

LeafCells::LeafCells(const PoissonDiskProblem& problem, const DiskMetric& metric)
    : torus_(problem.torus) {
    make_grid(problem, metric);
    const DomainCells domain(*problem.domain, grid_);
    for (int row = 0; row < grid_.rows; ++row)
        for (int column = 0; column < grid_.columns; ++column) {
            const std::size_t root =
                std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column);
            first_leaf_.push_back(count());
            Leaf leaf{.corner = grid_.corner(column, row)};
            leaf.is_whole = torus_ || domain.kind(root) == DomainCells::Kind::inside;
            std::vector<ConvexPiece> pieces;
            if (domain.kind(root) == DomainCells::Kind::border && !torus_)
                for (ConvexPiece piece : domain.parts(root)) {
                    for (int i = 0; i < piece.count; ++i)
                        piece.corner[std::size_t(i)] += leaf.corner;
                    pieces.push_back(piece);
                }
            if (problem.window && !(problem.window->intersects(leaf.corner) &&
                                    problem.window->intersects(leaf.corner + grid_.cell))) {
                if (leaf.is_whole)
                    pieces.push_back(square_at(leaf.corner, grid_.cell));
                leaf.is_whole = false;
                for (ConvexPiece& piece : pieces)
                    keep_box(piece, *problem.window);
                std::erase_if(pieces, [](const ConvexPiece& piece) { return piece.count < 3; });
            }
            add_leaves(leaf, std::move(pieces), metric);
        }
    first_leaf_.push_back(count());
    first_piece_.push_back(static_cast<std::uint32_t>(pieces_.size()));
    set_neighbours();
}

// Roots have the size of the largest disks' cells. The grid extends as far around the area to be
// filled as kept samples may matter.
void LeafCells::make_grid(const PoissonDiskProblem& problem, const DiskMetric& metric) {
    Box2 box = bounds(*problem.domain);
    const double largest = metric.scale_over(box).high;
    const double side = side_for(metric.least_distance() * largest);
    const double reach = metric.longest() * largest;
    if (!torus_) {
        if (problem.window) {
            box.min = {std::max(box.min.x, problem.window->min.x),
                       std::max(box.min.y, problem.window->min.y)};
            box.max = {std::min(box.max.x, problem.window->max.x),
                       std::min(box.max.y, problem.window->max.y)};
            box.max = {std::max(box.min.x, box.max.x), std::max(box.min.y, box.max.y)};
        }
        if (!problem.kept.empty()) {
            box.min -= Vec2(reach, reach);
            box.max += Vec2(reach, reach);
        }
    }
    const Vec2 size = box.size();
    if (!((size.x / side + 1) * (size.y / side + 1) < max_roots))
        throw Error(fmt::format("the domain of {:.4g} x {:.4g} m is too large for a distance of "
                                "{:.4g} m: there would be over {:.1g} elements",
                                size.x, size.y, metric.least_distance(), 0.35 * max_roots));
    grid_ = grid_over(box, side, torus_);
    period_ = size;
}

void LeafCells::add_leaves(const Leaf& leaf, std::vector<ConvexPiece> pieces,
                           const DiskMetric& metric) {
    const Vec2 size = grid_.cell * double(leaf.share);
    const Box2 all(leaf.corner, leaf.corner + size);
    const Range scale = metric.scale_over(all);
    const double wanted = side_for(metric.least_distance() * scale.low);
    // The depth is limited: where the scale jumps, quartering does not narrow its range.
    const bool is_empty = !leaf.is_whole && pieces.empty();
    if (!is_empty && std::max(size.x, size.y) > 1.5 * wanted && leaf.share > 0x1p-12F) {
        const Vec2 half = size / 2;
        for (int quarter = 0; quarter < 4; ++quarter) {
            const Leaf child{.corner = leaf.corner + Vec2(quarter % 2, quarter / 2) * half,
                             .share = leaf.share / 2,
                             .is_whole = leaf.is_whole};
            std::vector<ConvexPiece> parts; // none of a whole cell
            for (ConvexPiece piece : pieces) {
                keep_box(piece, {child.corner, child.corner + half});
                if (piece.count >= 3)
                    parts.push_back(piece);
            }
            add_leaves(child, std::move(parts), metric);
        }
        return;
    }
    leaves_.push_back(leaf);
    leaves_.back().reach = std::nextafter(static_cast<float>(metric.longest() * scale.high), 1e30F);
    first_piece_.push_back(static_cast<std::uint32_t>(pieces_.size()));
    for (const ConvexPiece& piece : pieces)
        if (area(piece) > 0)
            pieces_.push_back(piece);
}

// A cell matters to another when samples of either reach the other.
void LeafCells::set_neighbours() {
    const std::size_t roots = first_leaf_.size() - 1;
    std::vector<float> reach(roots, 0), farthest(roots, 0);
    for (std::size_t r = 0; r < roots; ++r)
        for (std::uint32_t leaf = first_leaf_[r]; leaf < first_leaf_[r + 1]; ++leaf)
            reach[r] = std::max(reach[r], leaves_[leaf].reach);
    const float overall = roots > 0 ? *std::max_element(reach.begin(), reach.end()) : 0;
    const bool even =
        std::all_of(reach.begin(), reach.end(), [&](float v) { return v > 0.8F * overall; });
    const auto wrapped = [](int i, int n) { return (i % n + n) % n; };
    for (int row = 0; row < grid_.rows && !even; ++row)
        for (int column = 0; column < grid_.columns; ++column) {
            const std::size_t r =
                std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column);
            const int dx = static_cast<int>(std::ceil(double(reach[r]) / grid_.cell.x));
            const int dy = static_cast<int>(std::ceil(double(reach[r]) / grid_.cell.y));
            for (int y = row - dy; y <= row + dy; ++y)
                for (int x = column - dx; x <= column + dx; ++x) {
                    const bool inside = x >= 0 && y >= 0 && x < grid_.columns && y < grid_.rows;
                    if (!inside && !torus_)
                        continue;
                    float& f =
                        farthest[std::size_t(wrapped(y, grid_.rows)) * std::size_t(grid_.columns) +
                                 std::size_t(wrapped(x, grid_.columns))];
                    f = std::max(f, reach[r]);
                }
        }
    for (std::size_t r = 0; r < roots; ++r)
        for (std::uint32_t leaf = first_leaf_[r]; leaf < first_leaf_[r + 1]; ++leaf)
            set_neighbours(leaves_[leaf],
                           double(even ? overall : std::max(leaves_[leaf].reach, farthest[r])));
}

void LeafCells::set_neighbours(Leaf& leaf, double distance) const {
    const Vec2 around(distance, distance);
    const Vec2 low = (leaf.corner - grid_.origin - around) / grid_.cell;
    const Vec2 high =
        (leaf.corner - grid_.origin + grid_.cell * double(leaf.share) + around) / grid_.cell;
    const auto whole = [](double v) { return static_cast<int>(std::floor(v)); };
    leaf.first_column = whole(low.x);
    leaf.last_column = whole(high.x);
    leaf.first_row = whole(low.y);
    leaf.last_row = whole(high.y);
    if (torus_)
        return;
    leaf.first_column = std::max(leaf.first_column, 0);
    leaf.first_row = std::max(leaf.first_row, 0);
    leaf.last_column = std::min(leaf.last_column, grid_.columns - 1);
    leaf.last_row = std::min(leaf.last_row, grid_.rows - 1);
}

std::span<const ConvexPiece> LeafCells::pieces(std::uint32_t leaf) const {
    return {pieces_.data() + first_piece_[leaf], first_piece_[leaf + 1] - first_piece_[leaf]};
}

ConvexPiece LeafCells::square(std::uint32_t leaf) const {
    return square_at(leaves_[leaf].corner, size(leaf));
}

std::optional<std::uint32_t> LeafCells::leaf_at(const Vec2& point) const {
    Vec2 p = point - grid_.origin;
    if (torus_)
        p -= Vec2(std::floor(p.x / period_.x) * period_.x, std::floor(p.y / period_.y) * period_.y);
    int column = static_cast<int>(std::floor(p.x / grid_.cell.x));
    int row = static_cast<int>(std::floor(p.y / grid_.cell.y));
    if (torus_) {
        column = std::min(column, grid_.columns - 1);
        row = std::min(row, grid_.rows - 1);
    }
    if (column < 0 || row < 0 || column >= grid_.columns || row >= grid_.rows)
        return std::nullopt;
    const std::size_t root = std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column);
    // The nearest of the root's cells, which is the one around the point up to rounding.
    std::uint32_t best = first_leaf_[root];
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t leaf = first_leaf_[root]; leaf < first_leaf_[root + 1]; ++leaf) {
        const Box2 b = box(leaf);
        const Vec2 d = p + grid_.origin - b.center();
        const double outside = std::max(std::abs(d.x) / b.size().x, std::abs(d.y) / b.size().y);
        if (outside < least) {
            least = outside;
            best = leaf;
        }
    }
    return best;
}

} // namespace scree
