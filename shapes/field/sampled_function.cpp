// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/field/sampled_function.h"

#include "core/error.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace scree {

namespace {

/// Parses the next number and removes it, with the space before it, from `text`.
template <class Number>
std::optional<Number> take(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    Number number{};
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (code != std::errc{})
        return {};
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

} // namespace

SampleGrid parse_samples(std::string_view text, int most) {
    const auto columns = take<int>(text);
    const auto rows = take<int>(text);
    if (!columns || !rows || *columns < 1 || *rows < 1 || *columns > most || *rows > most)
        throw Error(fmt::format("expected a function, or its samples: the numbers of columns and "
                                "rows, each 1 to {}, and then the values",
                                most));
    SampleGrid grid{.columns = *columns, .rows = *rows};
    const std::size_t count = std::size_t(*columns) * std::size_t(*rows);
    while (grid.values.size() < count) {
        const auto value = take<float>(text);
        if (!value || !std::isfinite(*value))
            throw Error(fmt::format("sample {} of {} is missing or not a finite number",
                                    grid.values.size() + 1, count));
        grid.values.push_back(*value);
    }
    if (text.find_first_not_of(' ') != std::string_view::npos)
        throw Error(fmt::format("there are more than the {} samples of {} columns and {} rows",
                                count, *columns, *rows));
    return grid;
}

} // namespace scree
