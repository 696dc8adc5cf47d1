// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/convex_piece.h"

#include <cstdint>
#include <vector>

namespace scree {

/// What of each cell is still uncovered: a list of convex pieces, or a mark in its place. The
/// pieces of all cells share one store, so that adding and taking them allocates nothing.
class UncoveredPieces {
  public:
    static constexpr std::int32_t nothing = -1; // an empty list
    static constexpr std::int32_t whole = -2;   // all of the cell
    static constexpr std::int32_t image = -3;   // the cell is the image of one across the torus

    struct Entry {
        ConvexPiece piece;
        double area = 0;
        std::int32_t next = nothing;
    };

    UncoveredPieces(std::size_t cells, std::int32_t mark) : first_(cells, mark) {}

    bool has_mark(std::uint32_t c, std::int32_t mark) const { return first_[c] == mark; }

    /// Replaces the cell's mark; a cell with pieces is cleared with `clear`.
    void set_mark(std::uint32_t c, std::int32_t mark) { first_[c] = mark; }

    void add(std::uint32_t c, const ConvexPiece& piece, double piece_area) {
        std::int32_t slot = unused_;
        if (slot == nothing) {
            slot = static_cast<std::int32_t>(entries_.size());
            entries_.emplace_back();
        } else {
            unused_ = at(slot).next;
        }
        at(slot) = {piece, piece_area, first_[c]};
        first_[c] = slot;
    }

    /// Takes out the piece in which `chosen`, a number in [0, area(c)), falls.
    Entry take(std::uint32_t c, double chosen) {
        std::int32_t* link = &first_[c];
        while (at(*link).next != nothing && chosen >= at(*link).area) {
            chosen -= at(*link).area;
            link = &at(*link).next;
        }
        const std::int32_t slot = *link;
        Entry taken = at(slot);
        *link = taken.next;
        at(slot).next = unused_;
        unused_ = slot;
        return taken;
    }

    /// Leaves nothing of the cell.
    void clear(std::uint32_t c) {
        while (first_[c] >= 0)
            take(c, 0);
        first_[c] = nothing;
    }

    /// The sum of the pieces' areas; 0 for a mark.
    double area(std::uint32_t c) const {
        double sum = 0;
        for (std::int32_t i = first_[c]; i >= 0; i = entries_[std::size_t(i)].next)
            sum += entries_[std::size_t(i)].area;
        return sum;
    }

  private:
    Entry& at(std::int32_t slot) { return entries_[static_cast<std::size_t>(slot)]; }

    std::vector<std::int32_t> first_; // of each cell's list, or its mark
    std::vector<Entry> entries_;
    std::int32_t unused_ = nothing; // the first of the list of free entries
};

} // namespace scree
