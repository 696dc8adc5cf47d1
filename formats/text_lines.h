// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of text formats share: lines, words and numbers, with places for messages.
#pragma once

#include "core/error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace scree {

/// The text of a file without the byte order mark at its start and the zero bytes at its end.
/// Throws Error (input) for UTF-16, which no mesh format allows.
std::string_view plain_text(std::string_view bytes);

/// The lines of a text one after the other, each ended by LF, CR LF or CR.
class TextLines {
  public:
    /// `text` must outlive this.
    explicit TextLines(std::string_view text) : rest_(text) {}

    /// Goes to the next line; false at the end.
    bool next();

    std::string_view text() const { return line_; }
    std::size_t number() const { return number_; } // 1-based

    /// What follows the line.
    std::string_view rest() const { return rest_; }

  private:
    std::string_view rest_;
    std::string_view line_;
    std::size_t number_ = 0;
};

/// Takes the first word off a line: what stands between blanks and tabs; "" when none is left.
std::string_view take_word(std::string_view& line);

/// Whether the words are equal but for the case of ASCII letters.
bool same_word(std::string_view a, std::string_view b);

/// A word in quotes for a message, shortened.
std::string in_quotes(std::string_view word);

/// The number that a whole word stands for, perhaps infinite or not a number. Throws Error (input)
/// without a place when it stands for none.
double number_of(std::string_view word);

/// The same, but it must be finite.
double finite_number_of(std::string_view word);

/// An error in a line: "line 7: ...".
Error line_error(std::size_t line, const std::string& message);

/// Counts what of a kind a reader meets, for one warning about all of it.
class Tally {
  public:
    void add(std::size_t place) {
        if (count_++ == 0)
            first_ = place;
    }
    std::size_t count() const { return count_; }
    std::size_t first() const { return first_; }

    /// "line 5 and 2 more", where `what` is "line".
    std::string text(std::string_view what) const;

  private:
    std::size_t first_ = 0;
    std::size_t count_ = 0;
};

} // namespace scree
