// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/ply_header.h"
#include "formats/text_lines.h"

#include <span>

namespace scree {

/// Reads the rows of a PLY file one after the other, in any of its three encodings. In text every
/// row is a line. Errors are Error (input) and name the line, or the element and the 0-based row.
class PlyRows {
  public:
    /// `header` must outlive this.
    explicit PlyRows(const PlyHeader& header);

    /// Reads row `row` of an element; rows must be read in the order in which the header has them.
    void next(const PlyHeader::Element& element, std::size_t row);

    /// The values of a property in the row that was read: one, or those of a list.
    std::span<const double> values(std::size_t property) const {
        return {values_.data() + starts_[property], starts_[property + 1] - starts_[property]};
    }

    /// Where the row was read: its line in text, otherwise its 0-based number.
    std::size_t place(std::size_t row) const;

    /// "line 12", or "face 3".
    std::string place_in_words(const PlyHeader::Element& element, std::size_t place) const;

    /// Throws when something follows the last row.
    void finish();

  private:
    void read(const PlyHeader::Element& element);
    double number(PlyHeader::Scalar type);
    double binary(PlyHeader::Scalar type);
    template <class T>
    double take();
    std::size_t list_length(PlyHeader::Scalar type);

    const PlyHeader& header_;
    TextLines lines_;       // of a text
    std::string_view rest_; // of the line, or of the binary body
    std::vector<double> values_;
    std::vector<std::size_t> starts_; // in values_, of each property, and the end
};

} // namespace scree
