// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/check_value.h"

#include "core/file.h"
#include "scenes/reader/words.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace scree {

namespace {

// Where a parameter has no limit of its own: beyond, nothing can be told apart in single precision.
constexpr double largest_number = 1e9;

std::optional<double> as_number(const Description& value) {
    if (!value.kind.empty())
        return {};
    if (const auto* integer = std::get_if<std::int64_t>(&value.data))
        return static_cast<double>(*integer);
    if (const auto* number = std::get_if<double>(&value.data))
        return *number;
    return {};
}

class Checker {
  public:
    Checker(const Given& given, const ParamSpec& spec, Mistakes& mistakes)
        : given_(given), spec_(spec), mistakes_(mistakes) {}

    Value check() {
        switch (spec_.type) {
        case ParamType::boolean:
            return plain<bool>();
        case ParamType::integer:
            return integer();
        case ParamType::number:
            return scalar();
        case ParamType::text:
        case ParamType::function:
            return plain<std::string>();
        case ParamType::choice:
            return choice();
        case ParamType::path:
            return path();
        case ParamType::vector2:
            return vector2(given_.value);
        case ParamType::vector3:
            return vector3();
        case ParamType::point3:
            return point3();
        case ParamType::color:
            return color();
        case ParamType::range:
            return range();
        case ParamType::points:
            return items<Vec2>(ParamType::vector2);
        case ParamType::points3:
            return items<Vec3>(ParamType::vector3);
        case ParamType::numbers:
            return one_or_more();
        case ParamType::field:
            return constant_field();
        default:
            throw std::logic_error(given_.path + ": is no plain value");
        }
    }

  private:
    Value mistake(std::string message, std::string hint = {}) {
        mistakes_.add(given_.where, given_.path, std::move(message), std::move(hint));
        return {};
    }

    Value wrong_type() { return wrong_type(given_.value, {}); }

    Value wrong_type(const Description& value, std::string hint) {
        return mistake(fmt::format("expected {}, got {}", type_in_words(spec_), in_words(value)),
                       std::move(hint));
    }

    double to_internal(double number) const {
        return spec_.unit == "deg" ? radians(number) : number;
    }

    // Reports a number that is not finite or out of range; false then.
    bool is_valid(double number) {
        if (!std::isfinite(number)) {
            mistake(std::isnan(number) ? "is not a number; was zero divided by zero?"
                                       : "is infinite; was something divided by zero?");
            return false;
        }
        if (in_range(number, spec_)) {
            if (spec_.type == ParamType::integer || std::abs(number) <= largest_number)
                return true;
            mistake(fmt::format("{} is out of range; expected {} to {}",
                                in_words(number, spec_.unit),
                                in_words(spec_.min.value_or(-largest_number)),
                                in_words(spec_.max.value_or(largest_number), spec_.unit)));
            return false;
        }
        const bool millimetres = spec_.unit == "m" && in_range(number / 1000, spec_);
        mistake(fmt::format("{} is out of range; expected {}", in_words(number, spec_.unit),
                            limits_in_words(spec_)),
                millimetres ? fmt::format("did you mean mm({})?", in_words(number)) : "");
        return false;
    }

    template <class T>
    Value plain() {
        const T* value = given_.value.kind.empty() ? std::get_if<T>(&given_.value.data) : nullptr;
        return value == nullptr ? wrong_type() : Value(*value);
    }

    Value scalar() {
        const std::optional<double> number = as_number(given_.value);
        if (!number)
            return wrong_type();
        return is_valid(*number) ? Value(to_internal(*number)) : Value();
    }

    Value constant_field() { // the value stays in the unit of scripts
        const std::optional<double> number = as_number(given_.value);
        if (!number)
            return wrong_type();
        return is_valid(*number) ? Value(*number) : Value();
    }

    Value integer() {
        const std::optional<double> number = as_number(given_.value);
        if (!number)
            return wrong_type();
        if (!is_valid(*number))
            return {};
        if (const auto* exact = std::get_if<std::int64_t>(&given_.value.data))
            return *exact;
        constexpr double largest =
            9007199254740992.0; // 2^53: larger integers are not exact in double
        if (*number != std::floor(*number) || std::abs(*number) > largest)
            return wrong_type();
        return static_cast<std::int64_t>(*number);
    }

    Value choice() {
        const auto* text =
            given_.value.kind.empty() ? std::get_if<std::string>(&given_.value.data) : nullptr;
        if (text == nullptr)
            return wrong_type();
        if (std::find(spec_.choices.begin(), spec_.choices.end(), *text) != spec_.choices.end())
            return *text;
        return mistake(fmt::format("expected {}, got \"{}\"", one_of(spec_.choices), *text),
                       did_you_mean(*text, spec_.choices));
    }

    Value path() {
        Value text = plain<std::string>();
        if (std::holds_alternative<std::monostate>(text))
            return text;
        const auto& name = std::get<std::string>(text);
        if (name.empty())
            return mistake("expected the path of a file, got an empty text");
        std::error_code code;
        const auto absolute =
            std::filesystem::absolute(resolve_path(name, given_.value.where.file), code);
        return code ? name : absolute.lexically_normal().string();
    }

    // A list of `count` finite numbers; empty after reporting an error.
    std::vector<double> numbers(const Description& from, std::size_t count) {
        const auto* list = from.kind.empty() ? std::get_if<Description::List>(&from.data) : nullptr;
        std::vector<double> out;
        if (list != nullptr && list->size() == count)
            for (const Description::Item& item : *list)
                if (const std::optional<double> number = as_number(*item.value))
                    out.push_back(*number);
        if (out.size() != count) {
            wrong_type(from, without_names(from, count));
            return {};
        }
        for (const double number : out)
            if (!is_valid(number))
                return {};
        return out;
    }

    Value vector2(const Description& from) {
        const std::vector<double> n = numbers(from, 2);
        return n.empty() ? Value() : Value(Vec2(to_internal(n[0]), to_internal(n[1])));
    }

    Value vector3() {
        if (const std::optional<double> all = as_number(given_.value); all && spec_.uniform)
            return is_valid(*all) ? Value(Vec3(static_cast<float>(to_internal(*all)))) : Value();
        const std::vector<double> n = numbers(given_.value, 3);
        if (n.empty())
            return {};
        return Vec3(static_cast<float>(to_internal(n[0])), static_cast<float>(to_internal(n[1])),
                    static_cast<float>(to_internal(n[2])));
    }

    Value point3() {
        const std::vector<double> n = numbers(given_.value, 3);
        return n.empty() ? Value() : Value(WideVec3(n[0], n[1], n[2]));
    }

    Value color() {
        if (const std::optional<double> grey = as_number(given_.value))
            return is_valid(*grey) ? Value(Color(static_cast<float>(*grey))) : Value();
        const std::vector<double> n = numbers(given_.value, 3);
        if (n.empty())
            return {};
        return Color(static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2]));
    }

    Value range() {
        if (const std::optional<double> both = as_number(given_.value)) {
            const double value = to_internal(*both);
            return is_valid(*both) ? Value(Range{value, value}) : Value();
        }
        const std::vector<double> n = numbers(given_.value, 2);
        if (n.empty())
            return {};
        if (n[0] > n[1])
            return mistake(fmt::format("expected {{low, high}} with low <= high, got {}",
                                       in_words(given_.value)));
        return Range{to_internal(n[0]), to_internal(n[1])};
    }

    // A list of values of one type T, each checked as a parameter of this type.
    template <class T>
    Value items(ParamType type) {
        const auto* list = given_.value.kind.empty()
                               ? std::get_if<Description::List>(&given_.value.data)
                               : nullptr;
        if (list == nullptr)
            return wrong_type();
        std::vector<T> out;
        out.reserve(list->size());
        const ParamSpec each{.name = spec_.name,
                             .type = type,
                             .unit = spec_.unit,
                             .min = spec_.min,
                             .max = spec_.max,
                             .above_min = spec_.above_min};
        for (std::size_t i = 0; i < list->size(); ++i) {
            const Description::Item& item = (*list)[i];
            const Given one{*item.value,
                            {given_.value.where.file, item.line},
                            fmt::format("{}[{}]", given_.path, i + 1)};
            const Value value = Checker(one, each, mistakes_).check();
            if (const auto* known = std::get_if<T>(&value))
                out.push_back(*known);
        }
        if (spec_.min_items && list->size() < *spec_.min_items)
            return mistake(
                fmt::format("expected at least {} points, got {}", *spec_.min_items, list->size()));
        return out.size() == list->size() ? Value(std::move(out)) : Value();
    }

    Value one_or_more() {
        if (!as_number(given_.value))
            return items<double>(ParamType::number);
        const Value one = scalar();
        const auto* number = std::get_if<double>(&one);
        return number == nullptr ? Value() : Value(std::vector<double>{*number});
    }

    const Given& given_;
    const ParamSpec& spec_;
    Mistakes& mistakes_;
};

} // namespace

bool in_range(double number, const ParamSpec& spec) {
    if (spec.min && (spec.above_min ? number <= *spec.min : number < *spec.min))
        return false;
    return !spec.max || number <= *spec.max;
}

Value check_value(const Given& given, const ParamSpec& spec, Mistakes& mistakes) {
    return Checker(given, spec, mistakes).check();
}

} // namespace scree
