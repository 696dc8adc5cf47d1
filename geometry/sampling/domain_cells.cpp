// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/domain_cells.h"

#include <algorithm>
#include <numeric>

namespace scree {

namespace {

// Cells within this distance of the border count as border cells, so that rounding misses none
// [cells].
constexpr double slack = 1e-7;

struct Span {
    int first = 0;
    int last = -1;
};

Span cells_between(double low, double high, int count) {
    if (!(high >= 0 && low < count))
        return {};
    return {static_cast<int>(std::floor(std::clamp(low, 0.0, count - 1.0))),
            static_cast<int>(std::floor(std::clamp(high, 0.0, count - 1.0)))};
}

} // namespace

CellGrid grid_over(const Box2& box, double side, bool fit) {
    const Vec2 size = box.size();
    CellGrid grid{.origin = box.min, .cell = {side, side}};
    if (fit) {
        grid.columns = static_cast<int>(std::ceil(size.x / side));
        grid.rows = static_cast<int>(std::ceil(size.y / side));
        grid.cell = {size.x / grid.columns, size.y / grid.rows};
    } else {
        grid.columns = static_cast<int>(std::floor(size.x / side)) + 1;
        grid.rows = static_cast<int>(std::floor(size.y / side)) + 1;
    }
    return grid;
}

DomainCells::DomainCells(const Region& region, const CellGrid& grid)
    : grid_(grid), kinds_(grid.size(), Kind::outside) {
    for (const Ring& ring : region.rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            mark_edge((ring[i] - grid.origin) / grid.cell,
                      (ring[(i + 1) % ring.size()] - grid.origin) / grid.cell);
    for (const auto& t : region.triangles) {
        ConvexPiece triangle;
        for (const std::uint32_t corner : t)
            triangle.add(region.vertices[corner] - grid.origin);
        add_triangle(triangle);
    }
    std::vector<std::uint32_t> order(parts_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return owner_[a] < owner_[b]; });
    std::vector<std::uint32_t> owner(order.size());
    std::vector<ConvexPiece> parts(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        owner[i] = owner_[order[i]];
        parts[i] = parts_[order[i]];
    }
    owner_ = std::move(owner);
    parts_ = std::move(parts);
}

// Marks the cells that the edge crosses; its ends are in cells.
void DomainCells::mark_edge(const Vec2& a, const Vec2& b) {
    const Vec2& low = a.y < b.y ? a : b;
    const Vec2& high = a.y < b.y ? b : a;
    const Span rows = cells_between(low.y - slack, high.y + slack, grid_.rows);
    for (int row = rows.first; row <= rows.last; ++row) {
        const auto x_at = [&](double y) {
            const double t = (std::clamp(y, low.y, high.y) - low.y) / (high.y - low.y);
            return low.x + (high.x - low.x) * t;
        };
        double x0 = low.x;
        double x1 = high.x;
        if (high.y - low.y > slack) {
            x0 = x_at(row - slack);
            x1 = x_at(row + 1 + slack);
        }
        const Span columns =
            cells_between(std::min(x0, x1) - slack, std::max(x0, x1) + slack, grid_.columns);
        for (int column = columns.first; column <= columns.last; ++column)
            kinds_[std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column)] =
                Kind::border;
    }
}

void DomainCells::add_triangle(const ConvexPiece& triangle) {
    const Box2 box = bounds(triangle);
    const Span rows = cells_between(box.min.y / grid_.cell.y, box.max.y / grid_.cell.y, grid_.rows);
    for (int row = rows.first; row <= rows.last; ++row) {
        ConvexPiece strip = triangle;
        keep_left(strip, {0, row * grid_.cell.y}, {1, 0});
        keep_left(strip, {0, (row + 1) * grid_.cell.y}, {-1, 0});
        if (strip.count < 3)
            continue;
        const Box2 strip_box = bounds(strip);
        const Span columns = cells_between(strip_box.min.x / grid_.cell.x,
                                           strip_box.max.x / grid_.cell.x, grid_.columns);
        for (int column = columns.first; column <= columns.last; ++column) {
            const std::size_t cell =
                std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column);
            if (kinds_[cell] != Kind::border) {
                kinds_[cell] = Kind::inside;
                continue;
            }
            ConvexPiece part = strip;
            keep_left(part, {column * grid_.cell.x, 0}, {0, -1});
            keep_left(part, {(column + 1) * grid_.cell.x, 0}, {0, 1});
            if (part.count < 3 || !(area(part) > 0))
                continue;
            const Vec2 corner = Vec2(column, row) * grid_.cell;
            for (int i = 0; i < part.count; ++i)
                part.corner[std::size_t(i)] -= corner;
            parts_.push_back(part);
            owner_.push_back(static_cast<std::uint32_t>(cell));
        }
    }
}

std::span<const ConvexPiece> DomainCells::parts(std::size_t cell) const {
    const auto [first, last] =
        std::equal_range(owner_.begin(), owner_.end(), static_cast<std::uint32_t>(cell));
    return {parts_.data() + (first - owner_.begin()), std::size_t(last - first)};
}

} // namespace scree
