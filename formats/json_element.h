// SPDX-License-Identifier: GPL-3.0-or-later
// JSON whose values know their places, for readers of files that programs wrote.
#pragma once

#include "core/error.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

struct JsonValue; // a value of the library, which headers do not show

/// A value in a JsonDocument, which must live longer. All errors are Errors (input) that name the
/// value: "nodes[3].scale".
class JsonElement {
  public:
    JsonElement(const JsonValue* value, std::string path) : value_(value), path_(std::move(path)) {}

    const std::string& path() const { return path_; }
    Error error(const std::string& message) const; // "nodes[3] MESSAGE"

    /// A field of this object. Errors: this is no object; `at`: there is no such field.
    std::optional<JsonElement> find(const std::string& name) const;
    JsonElement at(const std::string& name) const;
    std::vector<std::string> names() const; // of all fields

    /// The items of this array.
    std::vector<JsonElement> items() const;
    /// Those of a field; none where there is no such field.
    std::vector<JsonElement> items(const std::string& name) const;

    /// This value. Errors: it has another type.
    double number() const;
    bool flag() const;
    std::string text() const;
    /// A whole number from 0 to below `end`.
    std::size_t integer(std::size_t end = std::size_t{1} << 53) const;
    /// The number of an item in a list of this name that has `count` items.
    std::size_t reference(std::size_t count, const std::string& list) const;
    /// An array of `count` numbers; 0: of any length.
    std::vector<double> numbers(std::size_t count = 0) const;

    /// A field, or `fallback` where there is no such field.
    double number(const std::string& name, double fallback) const;
    bool flag(const std::string& name, bool fallback) const;
    std::string text(const std::string& name, const std::string& fallback) const;
    std::size_t integer(const std::string& name, std::size_t fallback) const;
    std::vector<double> numbers(const std::string& name, const std::vector<double>& fallback) const;

  private:
    const JsonValue* value_;
    std::string path_;
};

/// A JSON text.
class JsonDocument {
  public:
    /// Throws Error (input) with line and column for what is not JSON.
    explicit JsonDocument(std::string_view text);
    ~JsonDocument();
    JsonDocument(const JsonDocument&) = delete;
    JsonDocument& operator=(const JsonDocument&) = delete;

    JsonElement root() const { return {value_, ""}; }

  private:
    JsonValue* value_;
};

} // namespace scree
