// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/image_outline.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace scree {

namespace {

/// A square between the middles of four pixels; the first column and row stand left of and above
/// the image, whose surroundings count as below the threshold.
struct Cell {
    int x = 0;
    int y = 0;
};

enum Side : int { top, right, bottom, left };
constexpr std::array<Cell, 4> towards{Cell{0, -1}, Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}};

constexpr Side opposite(Side side) { return static_cast<Side>((side + 2) % 4); }

/// Follows the level line from cell to cell, the area above the threshold to its left (with y
/// down, as in the layout plane's x and z: from +x towards +y).
class Outliner {
  public:
    Outliner(const PixelGrid& pixels, float threshold)
        : pixels_(pixels), threshold_(threshold),
          followed_(std::size_t(pixels.width + 1) * std::size_t(pixels.height + 1)) {}

    std::vector<Ring> run(double min_area) {
        std::vector<Ring> rings;
        for (int y = 0; y <= pixels_.height; ++y)
            for (int x = 0; x <= pixels_.width; ++x)
                for (const Side in : {top, right, bottom, left})
                    if (enters({x, y}, in) && !is_followed({x, y}, in)) {
                        Ring ring = follow({x, y}, in);
                        if (std::abs(signed_area(ring)) >= min_area)
                            rings.push_back(std::move(ring));
                    }
        return rings;
    }

  private:
    bool in_image(int x, int y) const {
        return x >= 0 && y >= 0 && x < pixels_.width && y < pixels_.height;
    }

    float value(int x, int y) const {
        return pixels_.values[std::size_t(y) * std::size_t(pixels_.width) + std::size_t(x)];
    }

    bool above(int x, int y) const { return in_image(x, y) && value(x, y) >= threshold_; }

    /// The pixels at a cell's corners: where its sides begin, going top, right, bottom, left.
    static Cell corner(const Cell& cell, Side side) {
        return {cell.x - (side == top || side == left ? 1 : 0),
                cell.y - (side == top || side == right ? 1 : 0)};
    }

    bool above(const Cell& cell, Side side) const {
        const Cell pixel = corner(cell, side);
        return above(pixel.x, pixel.y);
    }

    // With the area to the left, a line enters through a side that begins above the threshold
    // and ends below it, and leaves through one that begins below.
    bool enters(const Cell& cell, Side side) const {
        return above(cell, side) && !above(cell, next(side));
    }
    bool leaves(const Cell& cell, Side side) const {
        return !above(cell, side) && above(cell, next(side));
    }

    static Side next(Side side) { return static_cast<Side>((side + 1) % 4); }
    static Side before(Side side) { return static_cast<Side>((side + 3) % 4); }

    /// Where the line that enters a cell leaves it.
    Side way_out(const Cell& cell, Side in) const {
        const bool crosswise = enters(cell, opposite(in));
        if (!crosswise) {
            for (const Side out : {next(in), opposite(in), before(in)})
                if (leaves(cell, out))
                    return out;
        }
        // Two corners above: joined, each line keeps to a corner below; else to one above.
        return joined(cell) ? next(in) : before(in);
    }

    bool joined(const Cell& cell) const {
        double sum = 0;
        for (const Side side : {top, right, bottom, left}) {
            const Cell pixel = corner(cell, side);
            sum += in_image(pixel.x, pixel.y) ? double{value(pixel.x, pixel.y)} - threshold_ : 0;
        }
        return sum >= 0;
    }

    /// Where the level line crosses the side of a cell.
    Vec2 crossing(const Cell& cell, Side side) const {
        Cell a = corner(cell, side);
        Cell b = corner(cell, next(side));
        if (!above(a.x, a.y))
            std::swap(a, b);
        double share = 0.5; // the border of the image
        if (in_image(b.x, b.y)) {
            const double high = value(a.x, a.y);
            share = (high - threshold_) / (high - value(b.x, b.y));
        }
        constexpr double apart = 1.0 / 1024;
        share = std::clamp(share, apart, 1 - apart);
        const Vec2 from(a.x + 0.5, a.y + 0.5);
        return from + Vec2(b.x - a.x, b.y - a.y) * share;
    }

    std::uint8_t& marks(const Cell& cell) {
        return followed_[std::size_t(cell.y) * std::size_t(pixels_.width + 1) +
                         std::size_t(cell.x)];
    }
    bool is_followed(const Cell& cell, Side in) { return (marks(cell) >> in & 1) != 0; }

    Ring follow(Cell cell, Side in) {
        Ring ring;
        while (!is_followed(cell, in)) {
            marks(cell) = static_cast<std::uint8_t>(marks(cell) | 1 << in);
            ring.push_back(crossing(cell, in));
            const Side out = way_out(cell, in);
            cell = {cell.x + towards[out].x, cell.y + towards[out].y};
            in = opposite(out);
        }
        return ring;
    }

    PixelGrid pixels_;
    float threshold_;
    std::vector<std::uint8_t> followed_; // per cell a bit for each side
};

} // namespace

std::vector<Ring> image_outlines(const PixelGrid& pixels, float threshold, double min_area) {
    return Outliner(pixels, threshold).run(min_area);
}

} // namespace scree
