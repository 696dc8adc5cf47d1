// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace scree {

/// A JSON value with its line.
struct Json {
    using Array = std::vector<Json>;
    using Object = std::vector<std::pair<std::string, Json>>;

    int line = 0;
    std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object> data;
};

/// Throws Error (input) at a line of a JSON file; `path` names the value if it has a name.
[[noreturn]] void fail_in_json(const std::string& file, int line, std::string message,
                               std::string path = {});

/// Parses the text. Throws Error with `file` and line for invalid JSON, duplicate names in one
/// object, and values nested too deeply.
Json parse_json(std::string_view text, const std::string& file);

} // namespace scree
