// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/words.h"

#include <fmt/format.h>

namespace scree {

std::string in_words(double number, const std::string& unit) {
    return fmt::format("{}{}{}", number, unit.empty() ? "" : " ", unit);
}

std::string in_words(const Description& given, const std::string& unit) {
    if (!given.kind.empty())
        return given.kind;
    struct Visitor {
        const std::string& unit;
        std::string operator()(std::monostate) const { return "nothing"; }
        std::string operator()(bool value) const { return value ? "true" : "false"; }
        std::string operator()(std::int64_t value) const {
            return fmt::format("{}{}{}", value, unit.empty() ? "" : " ", unit);
        }
        std::string operator()(double value) const { return in_words(value, unit); }
        std::string operator()(const std::string& value) const {
            constexpr std::size_t enough = 60;
            return fmt::format("the text \"{}\"",
                               value.size() <= enough ? value : value.substr(0, enough) + "...");
        }
        std::string operator()(const Description::List& list) const {
            std::string items;
            for (const Description::Item& item : list) {
                const Description& value = *item.value;
                const bool plain = value.kind.empty() &&
                                   !std::holds_alternative<Description::List>(value.data) &&
                                   !std::holds_alternative<Description::Table>(value.data);
                if (!plain || list.size() > 4)
                    return fmt::format("a list of {}", list.size());
                const auto* text = std::get_if<std::string>(&value.data);
                items += (items.empty() ? "" : ", ") +
                         (text != nullptr ? '"' + *text + '"' : in_words(value));
            }
            return "{" + items + "}";
        }
        std::string operator()(const Description::Table& table) const {
            if (table.empty())
                return "{}";
            std::string names;
            for (const auto& [name, item] : table)
                names += (names.empty() ? "" : ", ") + name;
            return fmt::format("a table with the field{} {}", table.size() == 1 ? "" : "s", names);
        }
    };
    return std::visit(Visitor{unit}, given.data);
}

std::string one_of(const std::vector<std::string>& names) {
    std::string out;
    for (std::size_t i = 0; i < names.size(); ++i)
        out += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
    return out;
}

std::string limits_in_words(const ParamSpec& spec) {
    const std::string unit = spec.unit.empty() ? "" : " " + spec.unit;
    if (spec.min && spec.max)
        return spec.above_min
                   ? fmt::format("more than {} and at most {}{}", *spec.min, *spec.max, unit)
                   : fmt::format("{} to {}{}", *spec.min, *spec.max, unit);
    if (spec.min)
        return fmt::format("{} {}{}", spec.above_min ? "more than" : "at least", *spec.min, unit);
    return fmt::format("at most {}{}", *spec.max, unit);
}

std::string type_in_words(const ParamSpec& spec) {
    switch (spec.type) {
    case ParamType::boolean:
        return "true or false";
    case ParamType::integer:
        return "a whole number";
    case ParamType::number:
        return "a number";
    case ParamType::text:
        return "a text";
    case ParamType::choice:
        return one_of(spec.choices);
    case ParamType::path:
        return "the path of a file";
    case ParamType::vector2:
        return spec.pair;
    case ParamType::vector3:
    case ParamType::point3:
        return "{x, y, z}";
    case ParamType::color:
        return "{r, g, b} or a number";
    case ParamType::texture:
        return "{r, g, b}, a number or a procedural.*";
    case ParamType::range:
        return "{low, high} or a number";
    case ParamType::points:
        return "a list of " + spec.pair;
    case ParamType::points3:
        return "a list of {x, y, z}";
    case ParamType::numbers:
        return "a number or a list of numbers";
    case ParamType::function:
        return "a function(x, z)";
    case ParamType::object:
        return "a " + objects_in_words(spec);
    case ParamType::field:
        return "a field.* or a number";
    case ParamType::record:
        return "a table with named fields";
    case ParamType::list:
        return is_object_list(spec)
                   ? "a list of " + kinds_in_words(spec.fields.front().families, " and ")
                   : "a list of tables";
    }
    return {};
}

std::string without_names(const Description& given, std::size_t count) {
    if (!given.kind.empty() || !std::holds_alternative<Description::Table>(given.data))
        return {};
    return fmt::format("the numbers stand without names, as in {}",
                       count == 2 ? "{0.1, 0.2}" : "{0.1, 0.2, 0.3}");
}

} // namespace scree
