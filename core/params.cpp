// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/params.h"

#include <cassert>
#include <stdexcept>

namespace scree {

namespace {

// Converts a default from the unit of scripts to the program's unit.
struct InProgramUnits {
    const ParamSpec& spec;
    double unit;

    Value operator()(double number) const {
        switch (spec.type) {
        case ParamType::integer:
            return static_cast<std::int64_t>(number);
        case ParamType::range:
            return Range{number * unit, number * unit};
        case ParamType::field:
            return number;
        case ParamType::numbers:
            return std::vector<double>{number * unit};
        default:
            return number * unit;
        }
    }
    Value operator()(std::int64_t number) const {
        return spec.type == ParamType::integer ? Value(number)
                                               : (*this)(static_cast<double>(number));
    }
    Value operator()(const Vec2& v) const { return v * unit; }
    Value operator()(const Vec3& v) const { return v * static_cast<float>(unit); }
    Value operator()(const Range& range) const {
        return Range{range.low * unit, range.high * unit};
    }
    Value operator()(const auto& other) const { return other; }
};

} // namespace

Value default_value(const ParamSpec& spec) {
    return std::visit(InProgramUnits{spec, spec.unit == "deg" ? radians(1) : 1}, spec.fallback);
}

ParamSpec number_spec(std::string name, std::string doc, std::string unit, double fallback,
                      double min, double max) {
    return {.name = std::move(name),
            .type = ParamType::number,
            .doc = std::move(doc),
            .unit = std::move(unit),
            .fallback = fallback,
            .min = min,
            .max = max};
}

ParamSpec optional_number_spec(std::string name, std::string doc, std::string unit, double min,
                               double max) {
    return {.name = std::move(name),
            .type = ParamType::number,
            .doc = std::move(doc),
            .unit = std::move(unit),
            .optional = true,
            .min = min,
            .max = max};
}

bool is_object_list(const ParamSpec& spec) {
    return spec.type == ParamType::list && spec.fields.size() == 1 &&
           spec.fields.front().type == ParamType::object;
}

std::string kinds_in_words(const std::vector<std::string>& families, std::string_view between) {
    std::string out;
    for (const std::string& family : families)
        out.append(out.empty() ? "" : between)
            .append(family)
            .append(family == "object" ? "" : ".*");
    return out;
}

std::string objects_in_words(const ParamSpec& spec) {
    std::string out = kinds_in_words(spec.families, " or ");
    for (const std::string& word : spec.choices)
        out += " or \"" + word + '"';
    return out;
}

void Params::set(const std::string& name, Value value, Location where) {
    entries_[name] = Entry{std::move(value), std::move(where)};
}

const Value* Params::find(const std::string& name) const {
    const auto entry = entries_.find(name);
    return entry == entries_.end() ? nullptr : &entry->second.value;
}

bool Params::has(const std::string& name) const {
    const Value* value = find(name);
    return value != nullptr && !std::holds_alternative<std::monostate>(*value);
}

template <class T>
const T& Params::get(const std::string& name) const {
    const Value* found = find(name);
    const T* value = found == nullptr ? nullptr : std::get_if<T>(found);
    if (value == nullptr)
        throw std::logic_error(path_ + "." + name + ": read with a type it was not declared with");
    return *value;
}

bool Params::flag(const std::string& name) const { return get<bool>(name); }
std::int64_t Params::integer(const std::string& name) const { return get<std::int64_t>(name); }
double Params::number(const std::string& name) const { return get<double>(name); }
const std::string& Params::text(const std::string& name) const { return get<std::string>(name); }
const Vec2& Params::vector2(const std::string& name) const { return get<Vec2>(name); }
const Vec3& Params::vector3(const std::string& name) const { return get<Vec3>(name); }
const WideVec3& Params::point3(const std::string& name) const { return get<WideVec3>(name); }
const Color& Params::color(const std::string& name) const { return get<Color>(name); }
const Range& Params::range(const std::string& name) const { return get<Range>(name); }

const std::vector<Vec2>& Params::points(const std::string& name) const {
    return get<std::vector<Vec2>>(name);
}

const std::vector<Vec3>& Params::points3(const std::string& name) const {
    return get<std::vector<Vec3>>(name);
}

const std::vector<double>& Params::numbers(const std::string& name) const {
    return get<std::vector<double>>(name);
}

const std::vector<Params>& Params::list(const std::string& name) const {
    return *get<std::shared_ptr<const std::vector<Params>>>(name);
}

const Params& Params::record(const std::string& name) const {
    assert(list(name).size() == 1);
    return list(name).front();
}

Location Params::where(const std::string& name) const {
    const auto entry = entries_.find(name);
    return entry == entries_.end() || entry->second.where.line == 0 ? where_ : entry->second.where;
}

ParamPlace Params::place(const std::string& name) const {
    return {where(name), path_ + "." + name};
}

Error Params::error(const std::string& name, std::string message, std::string hint) const {
    return place(name).error(std::move(message), std::move(hint));
}

void Params::warn(const std::string& name, std::string message, std::string hint) const {
    if (!warnings_)
        return;
    const ParamPlace at = place(name);
    warnings_->push_back({at.where, at.path, std::move(message), std::move(hint)});
}

Error ParamPlace::error(std::string message, std::string hint) const {
    return Error(Diagnostic{where, path, std::move(message), std::move(hint)});
}

} // namespace scree
