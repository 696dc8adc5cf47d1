// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/isotropic_disks.h"

#include "core/error.h"
#include "core/random.h"
#include "geometry/sampling/isotropic_cells.h"
#include "geometry/sampling/uncovered_pieces.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

// Numbers that follow from the distance and the domain.
struct Distances {
    double distance;  // [m]
    double conflict2; // squared, a little above the distance, as rounding may take that away
    double covered;   // a little below the distance
    double cell_side; // a cell's diagonal is a little below the distance
};

Distances distances_for(const Box2& box, double distance) {
    // Coordinates are rounded to about 2^-52 of the largest; differences and squares add a little.
    const double largest = std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x),
                                     std::abs(box.max.y), distance});
    const double doubt = 0x1p-49 * largest;
    return {distance, (distance + doubt) * (distance + doubt), std::max(0.0, distance - 2 * doubt),
            (distance - doubt) / std::numbers::sqrt2};
}

IsotropicCells cells_over(const Box2& box, const Distances& d, bool torus) {
    const Vec2 size = box.size();
    if (!(size.x / d.cell_side < 0x1p15 && size.y / d.cell_side < 0x1p15))
        throw Error(fmt::format("the domain is {:.4g} m wide, which is too much for a distance of "
                                "{:.4g} m: there would be over {:.2g} elements",
                                std::max(size.x, size.y), d.distance, 3e8));
    return {grid_over(box, d.cell_side, torus), torus};
}

// Each cell throws darts at times of a Poisson process whose rate is the area in which they may
// still succeed: at first the whole cell; after each miss what is left of the convex pieces that
// the samples around do not cover.
class Cells {
  public:
    Cells(const Region& domain, bool torus, double distance, std::uint64_t seed)
        : distances_(distances_for(bounds(domain), distance)),
          cells_(cells_over(bounds(domain), distances_, torus)),
          uncovered_(cells_.count(), torus ? UncoveredPieces::image : UncoveredPieces::nothing),
          seed_(seed) {
        start(domain);
    }

    std::uint32_t count() const { return cells_.count(); }
    float time(std::uint32_t c) const {
        return uncovered_.has_mark(c, UncoveredPieces::image) ? never : cells_.time(c);
    }
    std::uint32_t earliest_near(std::uint32_t c) const { return cells_.earliest_near(c); }
    void happen(std::uint32_t c);

    IsotropicDisks result() const;

  private:
    void start(const Region& domain);
    Random random_at(std::uint32_t c, float time) const;
    bool is_free(const Vec2& p, NearSamples& near) const;
    void put(std::uint32_t c, const Vec2& p);
    bool keep_reaching(NearSamples& near) const;
    void keep_uncovered(std::uint32_t c, const ConvexPiece& piece, const NearSamples& near);
    bool cut(ConvexPiece& piece, const NearSamples& near) const;

    Distances distances_;
    IsotropicCells cells_;
    UncoveredPieces uncovered_;
    std::uint64_t seed_;
    std::uint64_t trials_ = 0;
    std::uint64_t unresolved_ = 0;
};

void Cells::start(const Region& domain) {
    const CellGrid& grid = cells_.grid();
    const DomainCells domain_cells(domain, grid);
    const double cell_area = grid.cell.x * grid.cell.y;
    for (int row = 0; row < grid.rows; ++row) {
        Random random(seed_, Purpose::disk_start, std::uint64_t(row));
        for (int column = 0; column < grid.columns; ++column) {
            const double wait = random.exponential();
            const std::size_t cell =
                std::size_t(row) * std::size_t(grid.columns) + std::size_t(column);
            const std::uint32_t c = cells_.index(column, row);
            double share = 1;
            if (cells_.is_torus() || domain_cells.kind(cell) == DomainCells::Kind::inside) {
                uncovered_.set_mark(c, UncoveredPieces::whole);
            } else {
                uncovered_.clear(c);
                for (const ConvexPiece& part : domain_cells.parts(cell))
                    uncovered_.add(c, part, area(part));
                share = uncovered_.area(c) / cell_area;
            }
            if (share > 0)
                cells_.set_time(c, after(0, wait / share));
        }
    }
}

// Every event of every cell has its random numbers, whatever happened before.
Random Cells::random_at(std::uint32_t c, float time) const {
    return {seed_, Purpose::disk_dart, std::uint64_t{c} << 32 | std::bit_cast<std::uint32_t>(time)};
}

// A sample that is in the way is moved to the front, so that `cut` begins with it.
bool Cells::is_free(const Vec2& p, NearSamples& near) const {
    for (std::size_t k = 0; k < near.count; ++k)
        if ((near.position[k] - p).length2() < distances_.conflict2) {
            std::swap(near.position[0], near.position[k]);
            return false;
        }
    return true;
}

// Also ends the neighbouring cells that the sample covers wholly, which are most of those that will
// hold no sample. It cannot cover cells farther away.
void Cells::put(std::uint32_t c, const Vec2& p) {
    cells_.set_sample(c, p);
    uncovered_.clear(c);
    cells_.set_time(c, never);
    const Vec2& cell = cells_.grid().cell;
    // Squared distances to the farther side of the column or row before, at, and after.
    const auto farthest2 = [](double at, double side) {
        return std::array{(at + side) * (at + side), std::max(at * at, (side - at) * (side - at)),
                          (2 * side - at) * (2 * side - at)};
    };
    const std::array<double, 3> x2 = farthest2(p.x, cell.x);
    const std::array<double, 3> y2 = farthest2(p.y, cell.y);
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            if (x2[column] + y2[row] < distances_.covered * distances_.covered) {
                const std::uint32_t stride = cells_.stride();
                std::uint32_t near =
                    c + std::uint32_t(row) * stride - stride + std::uint32_t(column) - 1;
                if (cells_.time(near) == never)
                    continue;
                near = cells_.is_torus() ? cells_.real_of(near) : near;
                uncovered_.clear(near);
                cells_.set_time(near, never);
            }
}

// Keeps those samples whose disks cover a corner of the cell; returns false when one covers all of
// it. In single precision, whose rounding may keep more samples than needed.
bool Cells::keep_reaching(NearSamples& near) const {
    const auto w = static_cast<float>(cells_.grid().cell.x);
    const auto h = static_cast<float>(cells_.grid().cell.y);
    const Float4 x{0, w, w, 0};
    const Float4 y{0, 0, h, h};
    const auto covered2 = static_cast<float>(distances_.covered * distances_.covered);
    const Float4 surely = Float4{} + covered2 * 0.99999F;
    const Float4 perhaps = Float4{} + covered2 * 1.00001F;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < near.count; ++k) {
        const Float4 dx = x - static_cast<float>(near.position[k].x);
        const Float4 dy = y - static_cast<float>(near.position[k].y);
        const Float4 d2 = dx * dx + dy * dy;
        if (!any(d2 > surely))
            return false;
        near.position[kept] = near.position[k];
        kept += any(d2 < perhaps) ? 1 : 0;
    }
    near.count = kept;
    return true;
}

// Cuts away what the samples near cover. Returns whether anything is left.
bool Cells::cut(ConvexPiece& piece, const NearSamples& near) const {
    const BoundingCircle circle = bounding_circle(piece);
    const double beyond = distances_.distance + circle.radius;
    const double within = std::max(0.0, distances_.covered - circle.radius);
    for (std::size_t k = 0; k < near.count; ++k) {
        const double to_centre2 = (near.position[k] - circle.centre).length2();
        if (to_centre2 > beyond * beyond)
            continue;
        if (to_centre2 < within * within)
            return false;
        cut_away(piece, near.position[k], RoundForm{}, distances_.covered * distances_.covered);
        if (piece.count < 3)
            return false;
    }
    return true;
}

// Adds what the samples near leave of the piece: as one piece, or as two halves where little was
// cut away.
void Cells::keep_uncovered(std::uint32_t c, const ConvexPiece& piece, const NearSamples& near) {
    ConvexPiece left = piece;
    if (!cut(left, near))
        return;
    const double before = area(piece);
    const double now = area(left);
    const Vec2 size = bounds(left).size();
    const double least = 1e-9 * distances_.distance;
    if (std::max(size.x, size.y) < least || now < least * least) {
        ++unresolved_;
    } else if (now < before / 2) {
        uncovered_.add(c, left, now);
    } else {
        for (ConvexPiece& half : halves(left))
            if (half.count >= 3 && cut(half, near))
                uncovered_.add(c, half, area(half));
    }
}

void Cells::happen(std::uint32_t c) {
    ++trials_;
    const float time = cells_.time(c);
    Random random = random_at(c, time); // of which one block is enough
    const double u = random.bits() * 0x1p-32;
    const double v = random.bits() * 0x1p-32;
    NearSamples near = cells_.samples_near(c);
    const Vec2& cell = cells_.grid().cell;
    if (uncovered_.has_mark(c, UncoveredPieces::whole)) {
        const Vec2 p = Vec2(u, v) * cell;
        if (is_free(p, near)) {
            put(c, p);
            return;
        }
        uncovered_.clear(c);
        if (keep_reaching(near)) {
            ConvexPiece square;
            for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
                square.add(corner * cell);
            keep_uncovered(c, square, near);
        }
    } else {
        const UncoveredPieces::Entry hit =
            uncovered_.take(c, random.bits() * 0x1p-32 * uncovered_.area(c));
        const Vec2 p = point_in(hit.piece, hit.area, u, v);
        if (is_free(p, near)) {
            put(c, p);
            return;
        }
        keep_uncovered(c, hit.piece, near);
    }
    const double share = uncovered_.area(c) / (cell.x * cell.y);
    cells_.set_time(c, share > 0 ? after(time, random.exponential() / share) : never);
}

IsotropicDisks Cells::result() const {
    IsotropicDisks disks{.points = {}, .trials = trials_, .unresolved = unresolved_};
    const CellGrid& grid = cells_.grid();
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            if (const std::uint32_t c = cells_.index(column, row); cells_.has_sample(c))
                disks.points.push_back(grid.corner(column, row) + cells_.sample(c));
    return disks;
}

} // namespace

IsotropicDisks sample_isotropic_disks(const Region& domain, bool torus, double distance,
                                      std::uint64_t seed, const Context& context) {
    Cells cells(domain, torus, distance, seed);
    play(cells, context, "disks");
    return cells.result();
}

} // namespace scree
