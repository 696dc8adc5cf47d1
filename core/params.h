// SPDX-License-Identifier: GPL-3.0-or-later
// One declaration per parameter: it drives checking, `scree list`, the reference page and defaults.
#pragma once

#include "core/error.h"
#include "core/math.h"
#include "core/range.h"
#include "core/shared_object.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace scree {

enum class ParamType {
    boolean,
    integer,
    number,   // in scripts angles are degrees: unit "deg" is converted to radians on reading
    text,     // any string
    choice,   // one of ParamSpec::choices
    path,     // a file, relative to the script; made absolute on reading
    vector2,  // {x, z}
    vector3,  // {x, y, z}
    color,    // {r, g, b}, linear, or one number for grey
    range,    // {low, high} with low <= high, or one number for both
    points,   // list of {x, z}
    function, // a function(x, z) of a script, sampled on a grid: a text of numbers
    object,   // what a constructor of one of ParamSpec::families makes: mesh.*, region.*, ...
    field,    // field.*, or a number: the same value everywhere; in the unit of scripts
    texture,  // procedural.*, or a color
    record,   // a table with ParamSpec::fields
    list,     // a list of records with ParamSpec::fields
};

class Params;

using Value =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, Vec2, Vec3, Color, Range,
                 std::vector<Vec2>, SharedObject, std::shared_ptr<const std::vector<Params>>>;

/// The declaration of one parameter. `fallback`, `min` and `max` are in the unit of scripts.
struct ParamSpec {
    std::string name;
    ParamType type = ParamType::number;
    std::vector<std::string> families{}; // of an `object`: "mesh", "region", ...
    std::string doc{};                   // one sentence
    std::string unit{};                  // "m", "deg", ...
    Value fallback{};                    // monostate: required, unless `optional`
    bool optional = false;               // may be absent and then has no value
    std::optional<double> min{};         // for all values of a range or field
    std::optional<double> max{};
    bool above_min = false; // min itself is not allowed
    bool uniform = false;   // one number stands for all three of a vector3
    std::vector<std::string> choices{};
    std::vector<ParamSpec> fields{};
    std::optional<std::size_t> min_items{}; // of a list
};

/// The declaration of a number with a default.
ParamSpec number_spec(std::string name, std::string doc, std::string unit, double fallback,
                      double min, double max);

/// The declaration of a number that may be absent.
ParamSpec optional_number_spec(std::string name, std::string doc, std::string unit, double min,
                               double max);

/// A declaration's default as the value of its type, in the program's units; monostate without one.
Value default_value(const ParamSpec& spec);

/// Whether it is a list of objects: its items are written without the name of their one field.
bool is_object_list(const ParamSpec& spec);

/// "mesh.* or region.*"; `object` is a family of one.
std::string kinds_in_words(const std::vector<std::string>& families, std::string_view between);

/// Values by name, resolved and checked against their specs, with the place each was written.
/// Reading a name that no spec declares, or with another type than declared, is our own mistake
/// and asserts.
class Params {
  public:
    Params() = default;
    Params(std::string path, Location where) : path_(std::move(path)), where_(std::move(where)) {}

    void set(const std::string& name, Value value, Location where = {});

    bool has(const std::string& name) const; // given or defaulted
    bool flag(const std::string& name) const;
    std::int64_t integer(const std::string& name) const;
    double number(const std::string& name) const;
    const std::string& text(const std::string& name) const; // text, choice, path, function
    const Vec2& vector2(const std::string& name) const;
    const Vec3& vector3(const std::string& name) const;
    const Color& color(const std::string& name) const;
    const Range& range(const std::string& name) const;
    const std::vector<Vec2>& points(const std::string& name) const;

    /// The object of an `object`, `field` or `texture`; null when there is none, or when it is of
    /// another type, as one of several families may be.
    template <class T>
    std::shared_ptr<const T> object(const std::string& name) const {
        const Value* value = find(name);
        const auto* object = value == nullptr ? nullptr : std::get_if<SharedObject>(value);
        return object == nullptr ? nullptr : object->as<T>();
    }

    const std::vector<Params>& list(const std::string& name) const;
    const Params& record(const std::string& name) const;

    const std::string& path() const { return path_; }
    const Location& where() const { return where_; }
    Location where(const std::string& name) const;

    /// An error that names this parameter's file, line and path.
    Error error(const std::string& name, std::string message, std::string hint = {}) const;

  private:
    struct Entry {
        Value value;
        Location where;
    };
    const Value* find(const std::string& name) const;
    template <class T>
    const T& get(const std::string& name) const;

    std::string path_;
    Location where_;
    std::map<std::string, Entry> entries_;
};

} // namespace scree
