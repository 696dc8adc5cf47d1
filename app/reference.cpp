// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reference.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

std::string type_text(const ParamSpec& spec) {
    switch (spec.type) {
    case ParamType::boolean:
        return "true or false";
    case ParamType::integer:
        return "integer";
    case ParamType::number:
        return "number";
    case ParamType::text:
        return "text";
    case ParamType::choice:
        return fmt::format("{}", fmt::join(spec.choices, " | "));
    case ParamType::path:
        return "file name";
    case ParamType::vector2:
        return spec.pair;
    case ParamType::vector3:
    case ParamType::point3:
        return "{x, y, z}";
    case ParamType::color:
        return "{r, g, b}";
    case ParamType::texture:
        return "{r, g, b} or procedural.*";
    case ParamType::range:
        return "{low, high} or a number";
    case ParamType::points:
        return "list of " + spec.pair;
    case ParamType::points3:
        return "list of {x, y, z}";
    case ParamType::numbers:
        return "number or list of numbers";
    case ParamType::function:
        return "function(x, z)";
    case ParamType::object:
        return objects_in_words(spec);
    case ParamType::field:
        return "field.* or a number";
    case ParamType::record:
        return "table";
    case ParamType::list:
        return is_object_list(spec) ? "list of " + type_text(spec.fields.front())
                                    : "list of tables";
    }
    return "value";
}

std::string value_text(const Value& value) {
    struct Text {
        std::string operator()(std::monostate) const { return ""; }
        std::string operator()(bool b) const { return b ? "true" : "false"; }
        std::string operator()(std::int64_t i) const { return std::to_string(i); }
        std::string operator()(double d) const { return fmt::format("{:.6g}", d); }
        std::string operator()(const std::string& s) const { return '"' + s + '"'; }
        std::string operator()(const Vec2& v) const {
            return fmt::format("{{{:g}, {:g}}}", v.x, v.y);
        }
        std::string operator()(const Vec3& v) const {
            return fmt::format("{{{:g}, {:g}, {:g}}}", v.x, v.y, v.z);
        }
        std::string operator()(const WideVec3& v) const { return (*this)(Vec3(v)); }
        std::string operator()(const Color& c) const {
            return (*this)(static_cast<const Vec3&>(c));
        }
        std::string operator()(const Range& r) const {
            return fmt::format("{{{:g}, {:g}}}", r.low, r.high);
        }
        std::string operator()(const std::vector<Vec2>&) const { return ""; }
        std::string operator()(const std::vector<Vec3>&) const { return ""; }
        std::string operator()(const std::vector<double>&) const { return ""; }
        std::string operator()(const SharedObject&) const { return ""; }
        std::string operator()(const std::shared_ptr<const std::vector<Params>>&) const {
            return "";
        }
    };
    return std::visit(Text{}, value);
}

std::string default_text(const ParamSpec& spec) {
    if (!std::holds_alternative<std::monostate>(spec.fallback))
        return value_text(spec.fallback);
    if (spec.type == ParamType::record && !spec.optional)
        return "its own defaults";
    return spec.optional ? "none" : "required";
}

std::string range_text(const ParamSpec& spec) {
    if (spec.min && spec.max)
        return fmt::format("{}{:g} to {:g}", spec.above_min ? "above " : "", *spec.min, *spec.max);
    if (spec.min)
        return fmt::format("{} {:g}", spec.above_min ? "above" : "at least", *spec.min);
    if (spec.max)
        return fmt::format("at most {:g}", *spec.max);
    return "";
}

struct Line {
    std::string name;
    const ParamSpec* spec;
};

// Nested fields are listed under their path: components[].margin.
void flatten(const std::vector<ParamSpec>& specs, const std::string& prefix,
             std::vector<Line>& out) {
    for (const ParamSpec& spec : specs) {
        out.push_back({prefix + spec.name, &spec});
        if (is_object_list(spec))
            continue;
        flatten(spec.fields, prefix + spec.name + (spec.type == ParamType::list ? "[]." : "."),
                out);
    }
}

std::vector<Line> lines_of(const CatalogRow& row) {
    std::vector<Line> lines;
    flatten(row.params, "", lines);
    return lines;
}

std::string cell(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '|')
            out += '\\';
        out += c;
    }
    return out;
}

} // namespace

std::string full_name(const CatalogRow& row) {
    return row.family == row.name || row.family.empty() ? row.name : row.family + "." + row.name;
}

std::string plugin_overview(std::span<const CatalogRow> rows) {
    std::size_t width = 0;
    for (const CatalogRow& row : rows)
        width = std::max(width, full_name(row).size());
    std::string out;
    std::string family;
    for (const CatalogRow& row : rows) {
        if (row.family != family && !out.empty())
            out += '\n';
        family = row.family;
        out += fmt::format("{:<{}}  {}\n", full_name(row), width, row.doc);
    }
    return out + "\n`scree list NAME` shows the parameters of one.\n";
}

std::string plugin_details(const CatalogRow& row) {
    const std::vector<Line> lines = lines_of(row);
    std::size_t width = 0;
    for (const Line& line : lines)
        width = std::max(width, line.name.size());
    std::string out = fmt::format("{}: {}\n", full_name(row), row.doc);
    for (const Line& line : lines) {
        const ParamSpec& spec = *line.spec;
        out += fmt::format("  {:<{}}  {}{}; {}", line.name, width, type_text(spec),
                           spec.unit.empty() ? "" : " [" + spec.unit + "]",
                           default_text(spec) == "required" ? "required"
                                                            : "default " + default_text(spec));
        if (const std::string range = range_text(spec); !range.empty())
            out += "; " + range;
        out += fmt::format("\n  {:<{}}    {}\n", "", width, spec.doc);
    }
    return out;
}

std::string reference_markdown(std::span<const CatalogRow> rows) {
    std::string out = "# Reference\n\nMade by `scree list --markdown`.\n";
    std::string family;
    for (const CatalogRow& row : rows) {
        if (row.family != family) {
            out += fmt::format("\n## {}\n", row.family);
            if (row.family == "mesh")
                out +=
                    "\nThe foot of a mesh is below the middle of its bounding box, as low as its "
                    "lowest point: y = 0 there.\n";
        }
        family = row.family;
        out += fmt::format("\n### {}\n\n{}\n", full_name(row), row.doc);
        if (row.params.empty())
            continue;
        out += "\n| name | type | unit | default | range | what |\n|---|---|---|---|---|---|\n";
        for (const Line& line : lines_of(row))
            out += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", line.name,
                               cell(type_text(*line.spec)), line.spec->unit,
                               cell(default_text(*line.spec)), range_text(*line.spec),
                               cell(line.spec->doc));
    }
    return out;
}

} // namespace scree
