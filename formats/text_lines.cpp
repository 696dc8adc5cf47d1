// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace scree {

namespace {

constexpr std::string_view white = " \t\v\f";
constexpr std::size_t shown_letters = 20; // of a word in a message

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

} // namespace

std::string_view plain_text(std::string_view bytes) {
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
        throw Error("it is UTF-16 text; expected ASCII or UTF-8");
    if (bytes.starts_with("\xef\xbb\xbf"))
        bytes.remove_prefix(3);
    return bytes.substr(0, bytes.find_last_not_of('\0') + 1);
}

bool TextLines::next() {
    if (rest_.empty())
        return false;
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end);
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(rest_.size(), 1));
    ++number_;
    return true;
}

std::string_view take_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(white), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(white));
    line.remove_prefix(word.size());
    return word;
}

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

std::string in_quotes(std::string_view word) {
    std::string out(word.substr(0, shown_letters));
    std::replace_if(
        out.begin(), out.end(), [](char c) { return c >= 0 && c < ' '; }, '?');
    return '"' + out + (word.size() > shown_letters ? "...\"" : "\"");
}

double number_of(std::string_view word) {
    const bool plus = word.starts_with('+') && !word.starts_with("+-");
    double value = 0;
    const char* last = word.data() + word.size();
    const auto [end, code] = std::from_chars(word.data() + (plus ? 1 : 0), last, value);
    if (end == last && code == std::errc::result_out_of_range) {
        const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
        return tiny ? 0 : std::numeric_limits<double>::infinity();
    }
    if (end != last || code != std::errc())
        throw Error(in_quotes(word) + " is not a number" +
                    (word.find(',') == word.npos
                         ? ""
                         : "; expected a decimal point, and no commas between thousands"));
    return value;
}

double finite_number_of(std::string_view word) {
    const double value = number_of(word);
    if (!std::isfinite(value))
        throw Error(in_quotes(word) + " is not a number");
    return value;
}

Error line_error(std::size_t line, const std::string& message) {
    return Error(fmt::format("line {}: {}", line, message));
}

std::string Tally::text(std::string_view what) const {
    return fmt::format("{} {}", what, first_) +
           (count_ > 1 ? fmt::format(" and {} more", count_ - 1) : "");
}

} // namespace scree
