// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/isotropic_disks.h"

#include "core/error.h"
#include "core/float4.h"
#include "core/random.h"
#include "geometry/sampling/domain_cells.h"
#include "geometry/sampling/local_clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace scree {

namespace {

// A cell's diagonal is the distance, so that it holds one sample at most. Each cell throws its
// darts at times of a Poisson process whose rate is the area in which it may still succeed. That
// area is at first the whole cell; after each miss it is what convex pieces say is left uncovered.
class Cells {
  public:
    Cells(const Region& domain, bool torus, double distance, std::uint64_t seed);

    std::uint32_t count() const { return static_cast<std::uint32_t>(time_.size()); }
    float time(std::uint32_t c) const { return left_of_[c] == mirrored ? never : time_[c]; }
    std::uint32_t earliest_near(std::uint32_t c) const;
    void happen(std::uint32_t c);

    IsotropicDisks result() const;

  private:
    static constexpr int reach = 2; // cells: a distance is less than the sides of three
    static constexpr std::int32_t nothing = -1;
    static constexpr std::int32_t whole = -2;
    static constexpr std::int32_t mirrored = -3; // of a cell across the torus

    struct Left {
        ConvexPiece piece;
        double area = 0;
        std::int32_t next = nothing;
    };

    // Around the grid lie `reach` rows and columns: on a torus images of the cells across, else
    // cells in which nothing happens.
    std::uint32_t index(int column, int row) const {
        return std::uint32_t(row + reach) * stride_ + std::uint32_t(column + reach);
    }
    int column_of(std::uint32_t c) const { return int(c % stride_) - reach; }
    int row_of(std::uint32_t c) const { return int(c / stride_) - reach; }
    std::uint32_t real_of(std::uint32_t c) const;
    template <class Set>
    void for_images(std::uint32_t c, const Set& set);

    // The samples near a cell, as seen from its corner; the one that was in the way comes first.
    struct Near {
        std::array<Vec2, 24> spot;
        std::size_t count = 0;

        Near() {} // leaves the spots as they are
    };

    void start(const Region& domain);
    Random random_at(std::uint32_t c, float time) const;
    std::uint32_t occupied_near(std::uint32_t c) const;
    Near samples_near(std::uint32_t c) const;
    bool is_free(const Vec2& p, Near& near) const;
    void set_time(std::uint32_t c, float time);
    void put(std::uint32_t c, const Vec2& p);
    bool keep_reaching(Near& near) const;
    void keep_uncovered(std::uint32_t c, const ConvexPiece& piece, const Near& near);
    bool cut(ConvexPiece& piece, const Near& near) const;
    void add_left(std::uint32_t c, const ConvexPiece& piece, double piece_area);
    Left take_left(std::uint32_t c, double chosen);
    void drop_left(std::uint32_t c);
    double area_left(std::uint32_t c) const;

    CellGrid grid_;
    bool torus_;
    double distance_;
    double conflict2_; // squared, a little above the distance, as rounding may take that away
    double covered_;   // a little below
    std::uint64_t seed_;
    std::uint32_t stride_ = 0;
    std::array<std::uint32_t, 25> offset_{}; // of the indices of the cells near, row by row
    std::array<Vec2, 25> shift_;             // and where they lie from the one amidst them [m]
    std::vector<float> time_;
    std::vector<Vec2> spot_;               // of the cell's sample from its corner [m]
    std::vector<std::uint8_t> has_sample_; // a bit for each cell
    std::vector<std::int32_t> left_of_;
    std::vector<bool> at_rim_; // of a torus: the cell has images
    std::vector<Left> left_;   // the pieces of all cells, as lists
    std::int32_t unused_ = nothing;
    std::uint64_t trials_ = 0;
    std::uint64_t unresolved_ = 0;
};

Cells::Cells(const Region& domain, bool torus, double distance, std::uint64_t seed)
    : torus_(torus), distance_(distance), seed_(seed) {
    const Box2 box = bounds(domain);
    const Vec2 size = box.size();
    // Coordinates are rounded to about 2^-52 of the largest; differences and squares add a little.
    const double largest = std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x),
                                     std::abs(box.max.y), distance});
    const double doubt = 0x1p-49 * largest;
    conflict2_ = (distance + doubt) * (distance + doubt);
    covered_ = std::max(0.0, distance - 2 * doubt);
    const double side = (distance - doubt) / std::numbers::sqrt2;
    if (!(size.x / side < 0x1p15 && size.y / side < 0x1p15))
        throw Error(fmt::format("the domain is {:.4g} m wide, which is too much for a distance of "
                                "{:.4g} m: there would be over {:.2g} elements",
                                std::max(size.x, size.y), distance, 3e8));
    grid_ = grid_over(box, side, torus);
    stride_ = std::uint32_t(grid_.columns + 2 * reach);
    const std::size_t all = std::size_t(stride_) * std::size_t(grid_.rows + 2 * reach);
    time_.assign(all, never);
    spot_.resize(all);
    has_sample_.assign(all / 8 + 9, 0); // a word may be read from any byte
    left_of_.assign(all, torus ? mirrored : nothing);
    if (torus) {
        at_rim_.assign(all, true);
        for (int row = reach; row < grid_.rows - reach; ++row)
            for (int column = reach; column < grid_.columns - reach; ++column)
                at_rim_[index(column, row)] = false;
    }

    std::size_t k = 0;
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column, ++k) {
            shift_[k] = Vec2(column - reach, row - reach) * grid_.cell;
            offset_[k] = std::uint32_t(row - reach) * stride_ + std::uint32_t(column - reach);
        }
    start(domain);
}

void Cells::start(const Region& domain) {
    const DomainCells domain_cells(domain, grid_);
    const double cell_area = grid_.cell.x * grid_.cell.y;
    for (int row = 0; row < grid_.rows; ++row) {
        Random random(seed_, Purpose::disk_start, std::uint64_t(row));
        for (int column = 0; column < grid_.columns; ++column) {
            const double wait = random.exponential();
            const std::size_t cell =
                std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column);
            const std::uint32_t c = index(column, row);
            double share = 1;
            if (torus_ || domain_cells.kind(cell) == DomainCells::Kind::inside) {
                left_of_[c] = whole;
            } else {
                left_of_[c] = nothing;
                for (const ConvexPiece& part : domain_cells.parts(cell))
                    add_left(c, part, area(part));
                share = area_left(c) / cell_area;
            }
            if (share > 0)
                set_time(c, after(0, wait / share));
        }
    }
}

// Every event of every cell has numbers of its own, whatever happened before.
Random Cells::random_at(std::uint32_t c, float time) const {
    return {seed_, Purpose::disk_dart, std::uint64_t{c} << 32 | std::bit_cast<std::uint32_t>(time)};
}

std::uint32_t Cells::real_of(std::uint32_t c) const {
    const int column = column_of(c);
    const int row = row_of(c);
    const auto wrapped = [](int i, int n) { return i < 0 ? i + n : i >= n ? i - n : i; };
    return index(wrapped(column, grid_.columns), wrapped(row, grid_.rows));
}

// Calls set for the cell and on a torus for its images in the rows and columns around the grid.
template <class Set>
void Cells::for_images(std::uint32_t c, const Set& set) {
    set(c);
    if (!torus_ || !at_rim_[c])
        return;
    const auto other = [](int i, int n) { return i < reach ? i + n : i >= n - reach ? i - n : i; };
    const int column = column_of(c);
    const int row = row_of(c);
    const int across = other(column, grid_.columns);
    const int along = other(row, grid_.rows);
    if (across != column)
        set(index(across, row));
    if (along != row)
        set(index(column, along));
    if (across != column && along != row)
        set(index(across, along));
}

std::uint32_t Cells::earliest_near(std::uint32_t c) const {
    static_assert(reach == 2);
    const float* const first = &time_[c] - reach * std::ptrdiff_t(stride_) - reach;
    const auto four = [&](std::size_t i) {
        Float4 v;
        std::memcpy(&v, first + i * stride_, sizeof v);
        return v;
    };
    const auto fifth = [&](std::size_t i) { return first[i * stride_ + 4]; };
    const Float4 least =
        minimum(minimum(minimum(four(0), four(1)), minimum(four(2), four(3))), four(4));
    const float all =
        std::min({std::min(least[0], least[1]), std::min(least[2], least[3]),
                  std::min(fifth(0), fifth(1)), std::min(fifth(2), fifth(3)), fifth(4)});
    if (!(all < time_[c]))
        return c;
    for (std::size_t i = 0;; ++i) {
        const bool in_four = any(four(i) == Float4{} + all);
        if (!in_four && fifth(i) != all)
            continue;
        std::size_t j = 4;
        while (in_four && first[i * stride_ + --j] != all) {
        }
        const auto found = static_cast<std::uint32_t>(first + i * stride_ + j - time_.data());
        return torus_ ? real_of(found) : found;
    }
}

// A bit for each of the 25 cells near, row by row.
std::uint32_t Cells::occupied_near(std::uint32_t c) const {
    std::uint32_t mask = 0;
    std::uint32_t from = c - reach * stride_ - reach;
    for (unsigned row = 0; row < 5; ++row, from += stride_) {
        std::uint16_t bits = 0;
        std::memcpy(&bits, &has_sample_[from >> 3], sizeof bits);
        mask |= (std::uint32_t(bits) >> (from & 7U) & 31U) << (5 * row);
    }
    return mask;
}

Cells::Near Cells::samples_near(std::uint32_t c) const {
    Near near;
    for (std::uint32_t mask = occupied_near(c); mask != 0; mask &= mask - 1) {
        const auto k = static_cast<std::uint32_t>(std::countr_zero(mask));
        near.spot[near.count++] = spot_[c + offset_[k]] + shift_[k];
    }
    return near;
}

bool Cells::is_free(const Vec2& p, Near& near) const {
    for (std::size_t k = 0; k < near.count; ++k)
        if ((near.spot[k] - p).length2() < conflict2_) {
            std::swap(near.spot[0], near.spot[k]);
            return false;
        }
    return true;
}

void Cells::set_time(std::uint32_t c, float time) {
    for_images(c, [&](std::uint32_t i) { time_[i] = time; });
}

// Also ends the cells beside it that the sample covers whole, most of those that will hold none.
// Cells farther away it cannot cover.
void Cells::put(std::uint32_t c, const Vec2& p) {
    for_images(c, [&](std::uint32_t i) {
        spot_[i] = p;
        has_sample_[i >> 3] |= static_cast<std::uint8_t>(1U << (i & 7U));
    });
    drop_left(c);
    set_time(c, never);
    const Vec2& cell = grid_.cell;
    // Squared distances to the farther side of the column or row before, at, and after.
    const auto farthest2 = [](double at, double side) {
        return std::array{(at + side) * (at + side), std::max(at * at, (side - at) * (side - at)),
                          (2 * side - at) * (2 * side - at)};
    };
    const std::array<double, 3> x2 = farthest2(p.x, cell.x);
    const std::array<double, 3> y2 = farthest2(p.y, cell.y);
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            if (x2[column] + y2[row] < covered_ * covered_) {
                std::uint32_t near =
                    c + std::uint32_t(row) * stride_ - stride_ + std::uint32_t(column) - 1;
                if (time_[near] == never)
                    continue;
                near = torus_ ? real_of(near) : near;
                drop_left(near);
                set_time(near, never);
            }
}

void Cells::add_left(std::uint32_t c, const ConvexPiece& piece, double piece_area) {
    std::int32_t slot = unused_;
    if (slot == nothing) {
        slot = static_cast<std::int32_t>(left_.size());
        left_.emplace_back();
    } else {
        unused_ = left_[std::size_t(slot)].next;
    }
    left_[std::size_t(slot)] = {piece, piece_area, left_of_[c]};
    left_of_[c] = slot;
}

// The piece in which a number in [0, area_left) falls, taken out of the cell's list.
Cells::Left Cells::take_left(std::uint32_t c, double chosen) {
    std::int32_t* link = &left_of_[c];
    while (left_[std::size_t(*link)].next != nothing && chosen >= left_[std::size_t(*link)].area) {
        chosen -= left_[std::size_t(*link)].area;
        link = &left_[std::size_t(*link)].next;
    }
    const std::int32_t slot = *link;
    Left taken = left_[std::size_t(slot)];
    *link = taken.next;
    left_[std::size_t(slot)].next = unused_;
    unused_ = slot;
    return taken;
}

void Cells::drop_left(std::uint32_t c) {
    while (left_of_[c] >= 0)
        take_left(c, 0);
    left_of_[c] = nothing;
}

double Cells::area_left(std::uint32_t c) const {
    double sum = 0;
    for (std::int32_t i = left_of_[c]; i >= 0; i = left_[std::size_t(i)].next)
        sum += left_[std::size_t(i)].area;
    return sum;
}

// Keeps those samples whose disks cover a corner of the cell; false when one covers all of it. In
// single precision, with its doubt in favour of keeping.
bool Cells::keep_reaching(Near& near) const {
    const auto w = static_cast<float>(grid_.cell.x);
    const auto h = static_cast<float>(grid_.cell.y);
    const Float4 x{0, w, w, 0};
    const Float4 y{0, 0, h, h};
    const auto covered2 = static_cast<float>(covered_ * covered_);
    const Float4 surely = Float4{} + covered2 * 0.99999F;
    const Float4 perhaps = Float4{} + covered2 * 1.00001F;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < near.count; ++k) {
        const Float4 dx = x - static_cast<float>(near.spot[k].x);
        const Float4 dy = y - static_cast<float>(near.spot[k].y);
        const Float4 d2 = dx * dx + dy * dy;
        if (!any(d2 > surely))
            return false;
        near.spot[kept] = near.spot[k];
        kept += any(d2 < perhaps) ? 1 : 0;
    }
    near.count = kept;
    return true;
}

// Cuts what the samples near cover; whether anything is left.
bool Cells::cut(ConvexPiece& piece, const Near& near) const {
    const BoundingCircle circle = bounding_circle(piece);
    const double beyond = distance_ + circle.radius;
    const double within = std::max(0.0, covered_ - circle.radius);
    for (std::size_t k = 0; k < near.count; ++k) {
        const double to_centre2 = (near.spot[k] - circle.centre).length2();
        if (to_centre2 > beyond * beyond)
            continue;
        if (to_centre2 < within * within)
            return false;
        cut_away(piece, near.spot[k], RoundForm{}, covered_ * covered_);
        if (piece.count < 3)
            return false;
    }
    return true;
}

// Adds what the samples near leave of the piece: as one, or where that says little as two halves.
void Cells::keep_uncovered(std::uint32_t c, const ConvexPiece& piece, const Near& near) {
    ConvexPiece left = piece;
    if (!cut(left, near))
        return;
    const double before = area(piece);
    const double now = area(left);
    const Vec2 size = bounds(left).size();
    const double least = 1e-9 * distance_;
    if (std::max(size.x, size.y) < least || now < least * least) {
        ++unresolved_;
    } else if (now < before / 2) {
        add_left(c, left, now);
    } else {
        for (ConvexPiece& half : halves(left))
            if (half.count >= 3 && cut(half, near))
                add_left(c, half, area(half));
    }
}

void Cells::happen(std::uint32_t c) {
    ++trials_;
    const float time = time_[c];
    Random random = random_at(c, time); // of which one block is enough
    const double u = random.bits() * 0x1p-32;
    const double v = random.bits() * 0x1p-32;
    Near near = samples_near(c);
    if (left_of_[c] == whole) {
        const Vec2 p = Vec2(u, v) * grid_.cell;
        if (is_free(p, near)) {
            put(c, p);
            return;
        }
        left_of_[c] = nothing;
        if (keep_reaching(near)) {
            ConvexPiece square;
            for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
                square.add(corner * grid_.cell);
            keep_uncovered(c, square, near);
        }
    } else {
        const Left left = take_left(c, random.bits() * 0x1p-32 * area_left(c));
        const Vec2 p = point_in(left.piece, left.area, u, v);
        if (is_free(p, near)) {
            put(c, p);
            return;
        }
        keep_uncovered(c, left.piece, near);
    }
    const double share = area_left(c) / (grid_.cell.x * grid_.cell.y);
    set_time(c, share > 0 ? after(time, random.exponential() / share) : never);
}

IsotropicDisks Cells::result() const {
    IsotropicDisks disks{.points = {}, .trials = trials_, .unresolved = unresolved_};
    for (int row = 0; row < grid_.rows; ++row)
        for (int column = 0; column < grid_.columns; ++column)
            if (const std::uint32_t c = index(column, row);
                (has_sample_[c >> 3] >> (c & 7U) & 1U) != 0)
                disks.points.push_back(grid_.corner(column, row) + spot_[c]);
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
