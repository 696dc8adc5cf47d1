// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/maker.h"

#include "scenes/reader/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace scree {

namespace {

using List = Description::List;
using Table = Description::Table;

// {} is a table as well as a list.
bool is_table(const Description& value) {
    const auto* list = std::get_if<List>(&value.data);
    return std::holds_alternative<Table>(value.data) || (list != nullptr && list->empty());
}

const Table& fields_of(const Description& value) {
    static const Table none;
    const auto* table = std::get_if<Table>(&value.data);
    return table == nullptr ? none : *table;
}

} // namespace

Params Maker::params(const Description& table, const std::string& path,
                     const std::vector<ParamSpec>& specs) {
    Params out(path, table.where);
    if (!is_table(table)) {
        mistakes_.add(table.where, path,
                      "expected fields with names, got " +
                          in_words(Description{{}, {}, table.data}));
        return out;
    }
    const Table& fields = fields_of(table);
    std::vector<std::string> names;
    for (const ParamSpec& spec : specs)
        names.push_back(spec.name);
    for (const auto& [name, item] : fields)
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            std::string hint = did_you_mean(name, names);
            if (hint.empty())
                hint = names.empty() ? "it has no fields"
                                     : fmt::format("there are: {}", fmt::join(names, ", "));
            mistakes_.add({table.where.file, item.line}, path + "." + name, "unknown field", hint);
        }
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
    if (spec.type == ParamType::record) { // made of its fields' defaults
        const Description empty{table.where, {}, Table{}};
        return record({empty, table.where, path + "." + spec.name}, spec);
    }
    mistakes_.add(table.where, path + "." + spec.name,
                  "is missing; expected " + type_in_words(spec));
    return {};
}

Value Maker::value(const Given& given, const ParamSpec& spec) {
    switch (spec.type) {
    case ParamType::texture:
        return texture(given, spec);
    case ParamType::material:
        return material(given);
    case ParamType::mesh:
    case ParamType::region:
    case ParamType::shape:
        return shape(given, spec);
    case ParamType::field:
        return field(given, spec);
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
                  fmt::format("expected {}, got {}", type_in_words(spec), in_words(given.value)));
    return {};
}

Value Maker::texture(const Given& given, const ParamSpec& spec) {
    if (family_of(given.value) == "procedural") {
        const auto made = shared(procedurals_, tables().procedural, given);
        return made == nullptr ? Value() : Value(Texture{Color(0.0F), made});
    }
    if (!given.value.kind.empty())
        return wrong_kind(given, spec);
    ParamSpec color = spec;
    color.type = ParamType::color;
    const std::size_t before = mistakes_.count();
    const Description& value = given.value;
    // The message for a wrong type must offer procedurals too.
    if (!std::holds_alternative<List>(value.data) && !std::holds_alternative<double>(value.data) &&
        !std::holds_alternative<std::int64_t>(value.data))
        return wrong_kind(given, spec);
    const Value checked = check_value(given, color, mistakes_);
    return mistakes_.count() != before ? Value()
                                       : Value(Texture{std::get<Color>(checked), nullptr});
}

Value Maker::material(const Given& given) {
    if (family_of(given.value) != "material")
        return wrong_kind(given, {.name = {}, .type = ParamType::material});
    const auto known = material_ids_.find(&given.value);
    if (known != material_ids_.end())
        return known->second;
    MaterialId id;
    if (std::optional<Material> made = make<Material>(tables().material, given)) {
        id.index = static_cast<std::uint32_t>(materials_.size());
        materials_.push_back(std::move(*made));
    }
    material_ids_[&given.value] = id;
    return id;
}

template <class T, class Make>
std::shared_ptr<const T> Maker::shared(Made<std::shared_ptr<const T>>& made,
                                       const Registry<Make>& table, const Given& given) {
    const auto known = made.find(&given.value);
    if (known != made.end()) {
        if (known->second == nullptr)
            mistakes_.add_repeated();
        return known->second;
    }
    std::shared_ptr<const T> out;
    if constexpr (std::is_abstract_v<T>) {
        out = make<std::shared_ptr<const T>>(table, given).value_or(nullptr);
    } else {
        if (std::optional<T> value = make<T>(table, given))
            out = std::make_shared<const T>(std::move(*value));
    }
    return made[&given.value] = out;
}

Value Maker::shape(const Given& given, const ParamSpec& spec) {
    const std::string_view family = family_of(given.value);
    if (family == "mesh" && spec.type != ParamType::region) {
        const auto made = shared(meshes_, tables().mesh, given);
        return made == nullptr ? Value() : Value(made);
    }
    if (family == "region" && spec.type != ParamType::mesh) {
        const auto made = shared(regions_, tables().region, given);
        return made == nullptr ? Value() : Value(made);
    }
    return wrong_kind(given, spec);
}

Value Maker::field(const Given& given, const ParamSpec& spec) {
    if (family_of(given.value) == "field") {
        const auto made = shared(fields_, tables().field, given);
        if (made == nullptr)
            return {};
        // Any angle is as good as another; other values must be in range wherever one looks.
        constexpr double everywhere = 1e9;
        const Range range = made->over(Box2(Vec2(-everywhere), Vec2(everywhere)));
        if (made->period() == 0 && !(in_range(range.low, spec) && in_range(range.high, spec))) {
            mistakes_.add(given.where, given.path,
                          fmt::format("this {} has values from {} to {}; expected {}",
                                      given.value.kind, range.low, in_words(range.high, spec.unit),
                                      limits_in_words(spec)));
            return {};
        }
        return made;
    }
    return check_value(given, spec, mistakes_);
}

Value Maker::record(const Given& given, const ParamSpec& spec) {
    if (!given.value.kind.empty() || !is_table(given.value))
        return wrong_kind(given, spec);
    std::vector<Params> one;
    one.push_back(params(given.value, given.path, spec.fields));
    return std::make_shared<const std::vector<Params>>(std::move(one));
}

const Description::List* Maker::list(const Given& given, const std::string& expected) {
    static const List none;
    if (given.value.kind.empty() && is_table(given.value) && fields_of(given.value).empty())
        return &none;
    const auto* items = given.value.kind.empty() ? std::get_if<List>(&given.value.data) : nullptr;
    if (items == nullptr)
        mistakes_.add(given.where, given.path,
                      fmt::format("expected {}, got {}", expected, in_words(given.value)));
    return items;
}

Value Maker::records(const Given& given, const ParamSpec& spec) {
    const List* items = list(given, "a list of tables");
    if (items == nullptr)
        return {};
    if (spec.min_items && items->size() < *spec.min_items)
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
        } else if (spec.fields.size() == 1) { // palette = { {1, 0, 0} }: the one field alone
            const ParamSpec& field = spec.fields.front();
            Params one(path, where);
            one.set(field.name, value({*item.value, where, path}, field), where);
            out.push_back(std::move(one));
        } else {
            wrong_kind({*item.value, where, path}, {.name = {}, .type = ParamType::record});
        }
    }
    return std::make_shared<const std::vector<Params>>(std::move(out));
}

} // namespace scree
