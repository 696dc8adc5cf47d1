// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/number_checks.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace scree {

namespace {

/// The number that the whole text is.
template <class T>
std::optional<T> number_in(const std::string& text) {
    T value{};
    const char* end = text.data() + text.size();
    const auto [rest, code] = std::from_chars(text.data(), end, value);
    return code == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

} // namespace

std::string problem_of_positive(const std::string& given) {
    const std::optional<double> number = number_in<double>(given);
    if (number && std::isfinite(*number) && *number > 0)
        return "";
    return "expected a number above 0; got " + given;
}

std::string problem_of_seed(const std::string& given) {
    if (number_in<std::uint64_t>(given))
        return "";
    return fmt::format("expected a whole number from 0 to {}; got {}",
                       std::numeric_limits<std::uint64_t>::max(), given);
}

std::string problem_of_size(const std::string& given) {
    const std::optional<int> pixels = number_in<int>(given);
    if (pixels && *pixels >= 16 && *pixels <= 32768)
        return "";
    return fmt::format("expected one number of pixels from 16 to 32768, for the longer side of the "
                       ".png or .exr, whose form is that of the layout; got {}",
                       given);
}

} // namespace scree
