// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace scree {

/// Reads numbers and letters from an SVG attribute, one after the other.
class NumberScanner {
  public:
    explicit NumberScanner(std::string_view text) : text_(text) {}

    bool at_end(); // but for spaces
    void skip_spaces();
    void skip_comma(); // spaces with at most one comma between them

    bool number_follows(); // whether a number begins after spaces, or a comma promises one

    double number(); // after spaces and at most one comma; throws Error
    bool flag();     // 0 or 1, which need no space after it
    char letter();   // the next character, '\0' at the end
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    std::string_view word(); // letters, or % alone; may be empty

    /// Throws Error with the place and what stands there.
    [[noreturn]] void fail(const std::string& expected) const;

  private:
    std::string_view text_;
    std::size_t at_ = 0;
};

} // namespace scree
