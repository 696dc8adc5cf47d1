// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/maker.h"

#include "core/file.h"
#include "core/located.h"
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/strands.h"
#include "geometry/plane/field.h"
#include "scenes/reader/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace scree {

namespace {

using List = Description::List;
using Table = Description::Table;

// "mesh" of "mesh.banana".
std::string_view family_of(const Description& node) {
    return std::string_view(node.kind).substr(0, node.kind.find('.'));
}

// An empty list, {} in Lua, is a table too.
bool is_table(const Description& value) {
    const auto* list = std::get_if<List>(&value.data);
    return std::holds_alternative<Table>(value.data) || (list != nullptr && list->empty());
}

const Table& fields_of(const Description& value) {
    static const Table none;
    const auto* table = std::get_if<Table>(&value.data);
    return table == nullptr ? none : *table;
}

// How messages call it: generator.layout, or generator.layout "sweets" when it has a name.
std::string title_of(const Description& node) {
    const Table& fields = fields_of(node);
    const auto field = fields.find("name");
    const auto* name =
        field == fields.end() ? nullptr : std::get_if<std::string>(&field->second.value->data);
    return name == nullptr ? node.kind : fmt::format("{} \"{}\"", node.kind, *name);
}

// What is longer is more likely to be in millimetres than in metres.
constexpr float suspicious_length = 10; // [m]

Box3 box_of(const Mesh& mesh) { return bounds(mesh); }

Box3 box_of(const Strands& strands) {
    Box3 box;
    for (const Vec3& p : strands.points)
        box.extendBy(p);
    return box;
}

} // namespace

Params Maker::params(const Description& table, const std::string& path,
                     const std::vector<ParamSpec>& specs, const Registry<MakeObject>* family) {
    open_.push_back({path, specs, family});
    Params out = fields(table, path, specs);
    open_.pop_back();
    doubt_lengths(out, specs);
    return out;
}

// Here, where an object's scale is known, rather than where the file is read.
void Maker::doubt_lengths(const Params& given, const std::vector<ParamSpec>& specs) {
    Vec3 scale(1.0F);
    for (const ParamSpec& spec : specs)
        if (spec.name == "scale" && spec.type == ParamType::vector3 && given.has("scale"))
            scale = given.vector3("scale");
    const auto doubt = [&](const std::string& name, const auto& shape) {
        if (shape == nullptr || !shape->unit_unknown)
            return;
        const auto [found, is_new] = unsure_sizes_.try_emplace(shape.get());
        std::optional<Vec3>& known = found->second;
        if (is_new)
            known = box_of(*shape).size();
        if (!known)
            return;
        const Vec3 size = *known * scale;
        const float length = std::max({size.x, size.y, size.z});
        if (length > suspicious_length) {
            known.reset();
            given.warn(name,
                       fmt::format("{} is {:.4g} m long, its numbers taken as metres", shape->name,
                                   length),
                       "say its unit: \"mm\", \"cm\" or \"in\" if in those, \"m\" if in metres");
        }
    };
    for (const ParamSpec& spec : specs)
        if (spec.type == ParamType::object) {
            doubt(spec.name, given.object<Mesh>(spec.name));
            doubt(spec.name, given.object<Strands>(spec.name));
        }
}

Params Maker::fields(const Description& table, const std::string& path,
                     const std::vector<ParamSpec>& specs) {
    Params out(path, table.where);
    out.set_warnings(mistakes_.warnings());
    if (!is_table(table)) {
        mistakes_.add(table.where, path,
                      "expected fields with names, got " +
                          in_words(Description{{}, {}, table.data}));
        return out;
    }
    const Table& fields = fields_of(table);
    for (const auto& [name, item] : fields)
        if (std::ranges::find(specs, name, &ParamSpec::name) == specs.end())
            mistakes_.add({table.where.file, item.line}, fmt::format("{}.{}", path, name),
                          "unknown field", field_hint(name, open_));
    for (const ParamSpec& spec : specs) {
        const auto field = fields.find(spec.name);
        if (field == fields.end()) {
            out.set(spec.name, absent(table, path, spec));
            continue;
        }
        const Location where{table.where.file, field->second.line};
        out.set(spec.name, value({*field->second.value, where, path + "." + spec.name}, spec),
                where);
    }
    return out;
}

Value Maker::absent(const Description& table, const std::string& path, const ParamSpec& spec) {
    if (spec.optional && std::holds_alternative<std::monostate>(spec.fallback))
        return {};
    if (!std::holds_alternative<std::monostate>(spec.fallback))
        return default_value(spec);
    if (spec.type == ParamType::record) { // its default consists of the defaults of its fields
        const Description empty{table.where, {}, Table{}};
        return record({empty, table.where, path + "." + spec.name}, spec);
    }
    mistakes_.add(table.where, path + "." + spec.name,
                  "is missing; expected " + type_in_words(spec));
    return {};
}

Value Maker::value(const Given& given, const ParamSpec& spec) {
    switch (spec.type) {
    case ParamType::object:
        return object(given, spec);
    case ParamType::field:
        return field(given, spec);
    case ParamType::texture:
        return texture(given, spec);
    case ParamType::record:
        return record(given, spec);
    case ParamType::list:
        return records(given, spec);
    default:
        return check_value(given, spec, mistakes_);
    }
}

Value Maker::wrong_kind(const Given& given, const ParamSpec& spec) {
    mistakes_.add(given.where, given.path,
                  fmt::format("expected {}, got {}", type_in_words(spec), in_words(given.value)),
                  spec.type == ParamType::texture ? without_names(given.value, 3) : "");
    return {};
}

const Plugin<MakeObject>* Maker::plugin(const Given& given, const Registry<MakeObject>& family) {
    const std::string& kind = given.value.kind;
    const std::size_t dot = kind.find('.');
    const std::string name = dot == std::string::npos ? kind : kind.substr(dot + 1);
    if (const Plugin<MakeObject>* found = family.find(name))
        return found;
    std::vector<std::string> names;
    for (const Plugin<MakeObject>& known : family.plugins())
        names.push_back(known.name);
    const std::string near = nearest_name(name, names);
    mistakes_.add(given.value.where, kind, "unknown " + family.family(),
                  near.empty() ? fmt::format("there are: {}", fmt::join(names, ", "))
                               : "did you mean " + family.family() + "." + near + "?");
    return nullptr;
}

SharedObject Maker::make(const Given& given, const Registry<MakeObject>& family) {
    const Plugin<MakeObject>* found = plugin(given, family);
    if (found == nullptr)
        return {};
    const std::size_t before = mistakes_.count();
    const Params checked = params(given.value, title_of(given.value), found->params, &family);
    if (mistakes_.count() != before)
        return {};
    try {
        return located(checked, [&] { return found->make(checked); });
    } catch (const Error& error) {
        if (error.fault() != Fault::input)
            throw;
        mistakes_.add(error);
        return {};
    }
}

// Items of a scene stay apart: each has a number of its own. Relative paths mean other files in
// other folders.
SharedObject Maker::make_or_share(const Given& given, const Registry<MakeObject>& family) {
    if (family.family() == "generator" || family.family() == "object")
        return make(given, family);
    const std::string says = resolve_path("", given.value.where.file) + '\n' +
                             to_json(given.value, {.locations = false, .indent = false});
    if (const auto known = equal_.find(says); known != equal_.end())
        return known->second;
    SharedObject object = make(given, family);
    if (object)
        equal_.emplace(says, object);
    return object;
}

Value Maker::made(const Given& given, const Registry<MakeObject>& family) {
    const auto [known, first] = made_.try_emplace(&given.value);
    if (first) {
        const SharedObject object = make_or_share(given, family); // may change made_
        made_[&given.value] = object;
        return object ? Value(object) : Value();
    }
    if (!known->second)
        mistakes_.add_repeated();
    return known->second ? Value(known->second) : Value();
}

Value Maker::object(const Given& given, const ParamSpec& spec) {
    if (const auto* word = std::get_if<std::string>(&given.value.data);
        word != nullptr &&
        std::find(spec.choices.begin(), spec.choices.end(), *word) != spec.choices.end())
        return *word;
    const std::string_view name = family_of(given.value);
    const Registry<MakeObject>* family = catalog_.find(name);
    if (family == nullptr ||
        std::find(spec.families.begin(), spec.families.end(), name) == spec.families.end())
        return wrong_kind(given, spec);
    return made(given, *family);
}

Value Maker::texture(const Given& given, const ParamSpec& spec) {
    if (const std::string_view name = family_of(given.value); name == "procedural")
        return made(given, *catalog_.find(name));
    const Description& value = given.value;
    // The message for a wrong type must mention procedurals too.
    if (!value.kind.empty() ||
        !(std::holds_alternative<List>(value.data) || std::holds_alternative<double>(value.data) ||
          std::holds_alternative<std::int64_t>(value.data)))
        return wrong_kind(given, spec);
    ParamSpec color = spec;
    color.type = ParamType::color;
    return check_value(given, color, mistakes_);
}

Value Maker::field(const Given& given, const ParamSpec& spec) {
    const std::string_view name = family_of(given.value);
    if (name != "field")
        return check_value(given, spec, mistakes_);
    Value value = made(given, *catalog_.find(name));
    if (const auto* object = std::get_if<SharedObject>(&value)) {
        const auto field = object->as<Field>();
        // Angles are periodic and need no check; other values must be in range everywhere.
        constexpr double everywhere = 1e9;
        const Range range = field->over(Box2(Vec2(-everywhere), Vec2(everywhere)));
        if (field->period() == 0 && !(in_range(range.low, spec) && in_range(range.high, spec))) {
            mistakes_.add(given.where, given.path,
                          fmt::format("this {} has values from {} to {}; expected {}",
                                      given.value.kind, range.low, in_words(range.high, spec.unit),
                                      limits_in_words(spec)));
            return {};
        }
    }
    return value;
}

Value Maker::record(const Given& given, const ParamSpec& spec) {
    if (!given.value.kind.empty() || !is_table(given.value))
        return wrong_kind(given, spec);
    std::vector<Params> one;
    one.push_back(params(given.value, given.path, spec.fields));
    return std::make_shared<const std::vector<Params>>(std::move(one));
}

Value Maker::records(const Given& given, const ParamSpec& spec) {
    static const List none;
    const bool plain = given.value.kind.empty();
    const List* items = plain ? std::get_if<List>(&given.value.data) : nullptr;
    if (plain && is_table(given.value) && fields_of(given.value).empty())
        items = &none;
    if (items == nullptr)
        return wrong_kind(given, spec);
    if (spec.min_items && items->empty() && is_object_list(spec))
        mistakes_.add(given.where, given.path, "is empty; expected " + type_in_words(spec));
    else if (spec.min_items && items->size() < *spec.min_items)
        mistakes_.add(given.where, given.path,
                      fmt::format("expected at least {} item{}, got {}", *spec.min_items,
                                  *spec.min_items == 1 ? "" : "s", items->size()));
    std::vector<Params> out;
    for (std::size_t i = 0; i < items->size(); ++i) {
        const Description::Item& item = (*items)[i];
        const std::string path = fmt::format("{}[{}]", given.path, i + 1);
        const Location where{given.value.where.file, item.line};
        if (item.value->kind.empty() && is_table(*item.value)) {
            out.push_back(params(*item.value, path, spec.fields));
        } else if (spec.fields.size() == 1) { // palette = { {1, 0, 0} }: the only field's value
            const ParamSpec& field = spec.fields.front();
            Params one(path, where);
            one.set_warnings(mistakes_.warnings());
            one.set(field.name, value({*item.value, where, path}, field), where);
            out.push_back(std::move(one));
        } else {
            wrong_kind({*item.value, where, path}, {.name = {}, .type = ParamType::record});
        }
    }
    return std::make_shared<const std::vector<Params>>(std::move(out));
}

} // namespace scree
