// SPDX-License-Identifier: GPL-3.0-or-later
// The search for room that proves that there is none left.
#pragma once

#include "generators/layout/open_area.h"
#include "generators/layout/search_problem.h"

namespace scree {

struct SearchCounts {
    std::uint64_t cells = 0; // intervals of angle and scale over an area, examined
    std::uint64_t darts = 0;
    std::uint64_t queries = 0;
    std::uint64_t undecided = 0; // areas too small to go on with, where nothing could be placed
    void add(const SearchCounts& other);
};

/// Places elements in one part of the domain until none fits.
///
/// For an interval of angles and scales, a component may lie where none of the no-fit polygons of
/// its convex pieces against those of its neighbours holds its centre. The polygons are taken from
/// the area, exactly; what remains is tried with a dart and split into smaller intervals until it
/// is gone or, where no motion within an interval exceeds the clearance, its middle is certainly
/// free.
class SaturationSearch {
  public:
    /// `others` must not change meanwhile.
    SaturationSearch(const SearchProblem& problem, const Placements& others, Random random);

    /// Throws a dart at the box; whether its element was placed.
    bool try_dart(const Box2& box, std::uint64_t trial);

    /// Fills the box with the component until no more of them fits whose centre lies in it.
    void saturate(const Box2& box, std::uint32_t component);

    const std::vector<Dart>& placed() const { return placed_; } // by this search
    const SearchCounts& counts() const { return counts_; }

  private:
    struct Neighbour {
        Dart dart;
        Vec2 offset; // its position less the box's centre
    };
    struct Pair {
        std::uint32_t moving, fixed; // pieces
        float margin;                // of the fixed piece's element [m]
    };
    /// Its area is that of the `fragments` topmost fragments of the stack.
    struct Cell {
        double angle = 0, half_angle = 0; // [rad]
        double low = 1, high = 1;         // scale
        std::size_t fragments = 0;
        std::size_t first_pair = 0;
        std::size_t neighbours = 0; // how many there were when the pairs were listed
        int depth = 0;
        Imath::Box2f box{}; // around the fragments
    };
    /// How far an element's points move within a cell in each way [m].
    struct Extent {
        double turn, scale, place, fields;
    };
    enum class Trial { placed, taken, not_allowed };
    using PieceSpan = std::pair<std::size_t, std::size_t>;

    static constexpr int deepest = 400;
    static constexpr double widest_half_angle = 0.5; // beyond, no-fit polygons are mostly empty

    void gather(const Box2& box, double reach);
    void add_neighbours(const Dart& dart);
    void add_neighbour(const Dart& dart, const Vec2& offset);
    void add_pairs(PieceSpan pieces, double margin);
    void examine(Cell cell, std::size_t parent_pair, std::size_t parent_neighbours);
    bool is_allowed(Cell& cell) const;
    void turn_pieces(const Cell& cell);
    void take_pairs(const Cell& cell, std::size_t parent_pair, std::size_t parent_neighbours);
    bool is_covered(Cell& cell, std::size_t first_fragment, std::size_t first_pair,
                    std::size_t parent_pair);
    bool cover_new(Cell& cell, std::size_t first_fragment);
    Extent extent(const Cell& cell) const;
    bool throw_into(std::size_t first_fragment, const Cell& cell);
    Trial try_at(const Vec2f& point, double angle, double scale);
    bool is_free(const Dart& dart, const Vec2& offset);
    bool finish(Cell& cell, std::size_t first_fragment, bool is_last);
    void split(const Cell& cell, std::size_t first_fragment, const Extent& wide);
    Box2 world(const Imath::Box2f& box) const;
    bool has_fields() const {
        const LayoutFields& f = layout_.fields;
        return f.direction || f.scale || f.density || f.classes;
    }

    const SearchProblem& problem_;
    const LayoutProblem& layout_;
    const Placements& others_;
    Random random_;
    std::vector<Dart> placed_;
    SearchCounts counts_;

    // Of the box that is being searched.
    std::uint32_t component_ = 0;
    bool is_turned_freely_ = true;
    Vec2 centre_;
    double reach_ = 0; // from the centre, of what matters in the box [m]
    std::vector<std::uint32_t> found_;
    std::vector<Neighbour> neighbours_;
    std::vector<PieceSpan> pieces_of_; // per neighbour
    PieceSpan outside_;
    struct Pools {
        PiecePool fixed, moving;
    };
    Pools fine_, coarse_;

    // Stacks: a cell's part lies above its parent's.
    std::vector<Fragment> fragments_;
    std::vector<Pair> pairs_;
    std::vector<Fragment> rest_;
    HalfPlanes no_fit_;
};

} // namespace scree
