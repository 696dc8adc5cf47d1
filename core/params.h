// SPDX-License-Identifier: GPL-3.0-or-later
// Declarations of parameters, which drive checking, defaults, `scree list` and the reference page.
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
    vector2,  // {x, z}, or the two that ParamSpec::pair names
    vector3,  // {x, y, z}
    point3,   // {x, y, z}, a place in the scene: in double, since it may be far away
    color,    // {r, g, b}, linear, or one number for grey
    range,    // {low, high} with low <= high, or one number for both
    points,   // list of vector2
    points3,  // list of {x, y, z}
    numbers,  // a list of numbers, or one number
    function, // a script's function(x, z), sampled on a grid; the value is a text of numbers
    object,   // what a constructor of one of ParamSpec::families makes: mesh.*, region.*, ...
    field,    // field.*, or a number for a constant field; its values are in the unit of scripts
    texture,  // procedural.*, or a colour for a constant texture
    record,   // a table with ParamSpec::fields
    list,     // a list of records with ParamSpec::fields
};

class Params;

/// What users are told although nothing failed, in the order found.
using Warnings = std::vector<Diagnostic>;

using Value =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, Vec2, Vec3, WideVec3,
                 Color, Range, std::vector<Vec2>, std::vector<Vec3>, std::vector<double>,
                 SharedObject, std::shared_ptr<const std::vector<Params>>>;

/// The declaration of one parameter. `fallback` (the default), `min` and `max` are in the unit of
/// scripts.
struct ParamSpec {
    std::string name;
    ParamType type = ParamType::number;
    std::vector<std::string> families{}; // of an `object`: "mesh", "region", ...
    std::string doc{};                   // one sentence
    std::string unit{};                  // "m", "deg", ...
    Value fallback{};                    // monostate: required, unless `optional`
    bool optional = false;               // may be omitted, and then has no value
    std::optional<double> min{};         // applies to all values of a range or field
    std::optional<double> max{};
    bool above_min = false;      // min itself is not allowed
    bool uniform = false;        // a vector3 may be given as one number for all three
    std::string pair = "{x, z}"; // what the two numbers of a vector2 are
    std::vector<std::string>
        choices{}; // of a `choice`; of an `object` the words that may replace it
    std::vector<ParamSpec> fields{};
    std::optional<std::size_t> min_items{}; // of a list
};

/// The declaration of a number with a default.
ParamSpec number_spec(std::string name, std::string doc, std::string unit, double fallback,
                      double min, double max);

/// The declaration of a number that may be absent.
ParamSpec optional_number_spec(std::string name, std::string doc, std::string unit, double min,
                               double max);

/// The default in the program's units, converted to the parameter's type; monostate when there is
/// none.
Value default_value(const ParamSpec& spec);

/// Whether the parameter is a list of objects, whose items are written without a field name.
bool is_object_list(const ParamSpec& spec);

/// "mesh.* or region.*", where `between` is " or ". The family `object` is written without ".*".
std::string kinds_in_words(const std::vector<std::string>& families, std::string_view between);

/// What an `object` may be: "material.* or "file"".
std::string objects_in_words(const ParamSpec& spec);

/// Where a parameter was written and what it is called: what an error says that is found after the
/// parameters were read.
struct ParamPlace {
    Location where;
    std::string path; // "generator.layout.components[2].margin"

    Error error(std::string message, std::string hint = {}) const;
};

/// Values by name, resolved and checked against their specs, each with its location. Reading an
/// undeclared name, or one as another type than declared, is a programming error and asserts.
class Params {
  public:
    Params() = default;
    Params(std::string path, Location where) : path_(std::move(path)), where_(std::move(where)) {}

    void set(const std::string& name, Value value, Location where = {});

    /// Where `warn` puts its warnings; without, they are lost.
    void set_warnings(std::shared_ptr<Warnings> warnings) { warnings_ = std::move(warnings); }

    bool has(const std::string& name) const; // given, or has a default
    bool flag(const std::string& name) const;
    std::int64_t integer(const std::string& name) const;
    double number(const std::string& name) const;
    const std::string& text(const std::string& name) const; // text, choice, path, function
    const Vec2& vector2(const std::string& name) const;
    const Vec3& vector3(const std::string& name) const;
    const WideVec3& point3(const std::string& name) const;
    const Color& color(const std::string& name) const;
    const Range& range(const std::string& name) const;
    const std::vector<Vec2>& points(const std::string& name) const;
    const std::vector<Vec3>& points3(const std::string& name) const;
    const std::vector<double>& numbers(const std::string& name) const;

    /// The object of an `object`, `field` or `texture` parameter; null when there is none, or when
    /// its type is not T (several families may be allowed).
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
    ParamPlace place(const std::string& name) const;

    /// An error that names this parameter's file, line and path.
    Error error(const std::string& name, std::string message, std::string hint = {}) const;

    /// Tells the user something about this parameter that is no error: what of a file is not read,
    /// and does not make the result wrong.
    void warn(const std::string& name, std::string message, std::string hint = {}) const;

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
    std::shared_ptr<Warnings> warnings_;
};

} // namespace scree
