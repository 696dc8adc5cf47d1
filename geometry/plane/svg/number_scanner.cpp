// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/number_scanner.h"

#include "core/error.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace scree {

namespace {

constexpr double largest = 1e9;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char at(std::string_view text, std::size_t i) { return i < text.size() ? text[i] : '\0'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Of a number beyond the range of double: whether it is as good as 0.
bool is_tiny(std::string_view number) {
    const std::size_t exponent = number.find_first_of("eE");
    if (exponent != std::string_view::npos)
        return at(number, exponent + 1) == '-';
    return number.find_first_of("123456789") > number.find('.');
}

} // namespace

void NumberScanner::skip_spaces() {
    while (is_space(peek()))
        ++at_;
}

void NumberScanner::skip_comma() {
    skip_spaces();
    if (peek() == ',') {
        ++at_;
        skip_spaces();
    }
}

bool NumberScanner::at_end() {
    skip_spaces();
    return at_ == text_.size();
}

bool NumberScanner::number_follows() {
    skip_spaces();
    const char c = peek();
    // A comma promises a number.
    return is_digit(c) || c == '.' || c == '+' || c == '-' || c == ',';
}

double NumberScanner::number() {
    skip_comma();
    const std::size_t begin = at_;
    const bool plus = peek() == '+';
    const std::size_t digits = at_ + (plus || peek() == '-' ? 1 : 0);
    // from_chars also reads "nan" and "inf", which no number of SVG is.
    if (!is_digit(at(text_, digits)) &&
        !(at(text_, digits) == '.' && is_digit(at(text_, digits + 1))))
        fail("a number");
    double value = 0;
    const char* first = text_.data() + begin + (plus ? 1 : 0);
    const auto [end, code] = std::from_chars(first, text_.data() + text_.size(), value);
    at_ = static_cast<std::size_t>(end - text_.data());
    const std::string_view written = text_.substr(begin, at_ - begin);
    if (code == std::errc::result_out_of_range && is_tiny(written))
        return 0;
    if (code != std::errc{} || std::abs(value) > largest)
        throw Error(fmt::format("{:.30} at letter {} is too large: numbers go to {:g}", written,
                                begin + 1, largest));
    return value;
}

bool NumberScanner::flag() {
    skip_comma();
    if (peek() != '0' && peek() != '1')
        fail("the flag 0 or 1");
    return text_[at_++] == '1';
}

char NumberScanner::letter() { return at_ < text_.size() ? text_[at_++] : '\0'; }

std::string_view NumberScanner::word() {
    const std::size_t begin = at_;
    if (peek() == '%')
        ++at_;
    else
        while (is_letter(peek()))
            ++at_;
    return text_.substr(begin, at_ - begin);
}

void NumberScanner::fail(const std::string& expected) const {
    if (at_ >= text_.size())
        throw Error(fmt::format("expected {} at the end", expected));
    std::string found;
    for (const char c : text_.substr(at_, 12)) // part of an error message: printable ASCII only
        found += c >= ' ' && c <= '~' ? c : '?';
    throw Error(fmt::format("expected {} at letter {}, found \"{}\"", expected, at_ + 1, found));
}

} // namespace scree
