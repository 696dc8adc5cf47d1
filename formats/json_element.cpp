// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/json_element.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace scree {

namespace {

using nlohmann::json;

const json& as_json(const JsonValue* value) { return *reinterpret_cast<const json*>(value); }
const JsonValue* as_value(const json& value) { return reinterpret_cast<const JsonValue*>(&value); }

// "a text"; of a number or a flag its value.
std::string in_words(const json& value) {
    if (value.is_object())
        return "an object";
    if (value.is_array())
        return fmt::format("a list of {}", value.size());
    if (value.is_string())
        return "a text";
    return value.dump();
}

Error wrong_type(const JsonElement& element, const char* expected, const json& value) {
    return element.error(fmt::format("must be {}, not {}", expected, in_words(value)));
}

} // namespace

Error JsonElement::error(const std::string& message) const {
    return Error(path_.empty() ? "it " + message : path_ + " " + message);
}

std::optional<JsonElement> JsonElement::find(const std::string& name) const {
    const json& value = as_json(value_);
    if (!value.is_object())
        throw wrong_type(*this, "an object", value);
    const auto found = value.find(name);
    if (found == value.end())
        return std::nullopt;
    return JsonElement(as_value(*found), path_.empty() ? name : path_ + "." + name);
}

JsonElement JsonElement::at(const std::string& name) const {
    if (auto found = find(name))
        return *std::move(found);
    throw error("has no " + name);
}

std::vector<std::string> JsonElement::names() const {
    const json& value = as_json(value_);
    if (!value.is_object())
        throw wrong_type(*this, "an object", value);
    std::vector<std::string> out;
    for (const auto& field : value.items())
        out.push_back(field.key());
    return out;
}

std::vector<JsonElement> JsonElement::items() const {
    const json& value = as_json(value_);
    if (!value.is_array())
        throw wrong_type(*this, "a list", value);
    std::vector<JsonElement> out;
    for (std::size_t i = 0; i < value.size(); ++i)
        out.emplace_back(as_value(value[i]), fmt::format("{}[{}]", path_, i));
    return out;
}

std::vector<JsonElement> JsonElement::items(const std::string& name) const {
    const auto found = find(name);
    return found ? found->items() : std::vector<JsonElement>{};
}

double JsonElement::number() const {
    const json& value = as_json(value_);
    if (!value.is_number())
        throw wrong_type(*this, "a number", value);
    return value.get<double>();
}

bool JsonElement::flag() const {
    const json& value = as_json(value_);
    if (!value.is_boolean())
        throw wrong_type(*this, "true or false", value);
    return value.get<bool>();
}

std::string JsonElement::text() const {
    const json& value = as_json(value_);
    if (!value.is_string())
        throw wrong_type(*this, "a text", value);
    return value.get<std::string>();
}

std::size_t JsonElement::integer(std::size_t end) const {
    const double value = number(); // programs write 3 as 3.0 too
    if (!(value >= 0 && value < static_cast<double>(end)) ||
        value != static_cast<double>(static_cast<std::size_t>(value)))
        throw error(fmt::format("must be a whole number from 0 to {}, not {}", end - 1,
                                as_json(value_).dump()));
    return static_cast<std::size_t>(value);
}

std::size_t JsonElement::reference(std::size_t count, const std::string& list) const {
    const std::size_t index = integer();
    if (index >= count) {
        const std::string there_are = count == 0 ? "no " + list
                                      : count == 1
                                          ? fmt::format("only {}[0]", list)
                                          : fmt::format("only {0}[0] to {0}[{1}]", list, count - 1);
        throw error(fmt::format("is {}, but the file has {}", index, there_are));
    }
    return index;
}

std::vector<double> JsonElement::numbers(std::size_t count) const {
    const json& value = as_json(value_);
    if (!value.is_array())
        throw wrong_type(*this, "a list of numbers", value);
    if (count != 0 && value.size() != count)
        throw error(fmt::format("must be {} numbers, not {}", count, value.size()));
    std::vector<double> out;
    out.reserve(value.size());
    for (const json& item : value) {
        if (!item.is_number())
            throw wrong_type(*this, "a list of numbers", item);
        out.push_back(item.get<double>());
    }
    return out;
}

double JsonElement::number(const std::string& name, double fallback) const {
    const auto found = find(name);
    return found ? found->number() : fallback;
}

bool JsonElement::flag(const std::string& name, bool fallback) const {
    const auto found = find(name);
    return found ? found->flag() : fallback;
}

std::string JsonElement::text(const std::string& name, const std::string& fallback) const {
    const auto found = find(name);
    return found ? found->text() : fallback;
}

std::size_t JsonElement::integer(const std::string& name, std::size_t fallback) const {
    const auto found = find(name);
    return found ? found->integer() : fallback;
}

std::vector<double> JsonElement::numbers(const std::string& name,
                                         const std::vector<double>& fallback) const {
    const auto found = find(name);
    return found ? found->numbers(fallback.size()) : fallback;
}

JsonDocument::JsonDocument(std::string_view text) : value_(nullptr) {
    try {
        value_ = reinterpret_cast<JsonValue*>(new json(json::parse(text)));
    } catch (const json::exception& problem) {
        // "[json.exception...] parse error at line 1, column 2: ...; last read: '...'"
        std::string_view what = problem.what();
        what = what.substr(0, what.find("; last read"));
        what.remove_prefix(std::min(what.find("] ") + 2, what.size()));
        throw Error("its JSON is damaged: " + std::string(what));
    }
}

JsonDocument::~JsonDocument() { delete reinterpret_cast<json*>(value_); }

} // namespace scree
