// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/json.h"
#include "scenes/reader/json_tree.h"

#include <fmt/format.h>
#include <limits>
#include <optional>

namespace scree {

namespace {

// Converts Json values to nodes.
class Reader {
  public:
    explicit Reader(const std::string& file) : json_file_(file) {}

    DescriptionNode read(const Json& root) {
        if (const auto* object = std::get_if<Json::Object>(&root.data))
            if (const Json* files = member(*object, "$files"))
                read_files(*files);
        const Location start = tracked() ? Location{files_.front(), 0} : Location{};
        return node(root, start);
    }

  private:
    bool tracked() const { return !files_.empty(); }

    static const Json* member(const Json::Object& object, std::string_view name) {
        for (const auto& [key, value] : object)
            if (key == name)
                return &value;
        return nullptr;
    }

    void read_files(const Json& json) {
        const auto* array = std::get_if<Json::Array>(&json.data);
        if (array == nullptr || array->empty())
            fail_in_json(json_file_, json.line, "expected a list of file names", "$files");
        for (const Json& name : *array) {
            if (!std::holds_alternative<std::string>(name.data))
                fail_in_json(json_file_, name.line, "expected a list of file names", "$files");
            files_.push_back(std::get<std::string>(name.data));
        }
    }

    std::int64_t integer(const Json& json, const std::string& path, std::int64_t min,
                         std::int64_t max) const {
        const auto* value = std::get_if<std::int64_t>(&json.data);
        if (value == nullptr || *value < min || *value > max)
            fail_in_json(json_file_, json.line,
                         fmt::format("expected a whole number from {} to {}", min, max), path);
        return *value;
    }

    int line_number(const Json& json, const std::string& path) const {
        return static_cast<int>(integer(json, path, 0, std::numeric_limits<int>::max()));
    }

    const std::string& text(const Json& json, const std::string& path) const {
        const auto* value = std::get_if<std::string>(&json.data);
        if (value == nullptr)
            fail_in_json(json_file_, json.line, "expected a text", path);
        return *value;
    }

    DescriptionNode node(const Json& json, const Location& inherited) {
        auto made = std::make_shared<Description>();
        made->where = tracked() ? inherited : Location{json_file_, json.line};
        std::optional<std::int64_t> id;
        if (const auto* object = std::get_if<Json::Object>(&json.data)) {
            if (const Json* reference = member(*object, "$ref"))
                return referenced(*object, *reference);
            id = read_object(*object, *made);
        } else {
            read_plain(json, *made, nullptr);
        }
        if (id)
            by_id_.emplace(*id, made);
        return made;
    }

    DescriptionNode referenced(const Json::Object& object, const Json& reference) const {
        if (object.size() != 1)
            fail_in_json(json_file_, reference.line, "stands with other fields", "$ref");
        const auto found = by_id_.find(integer(reference, "$ref", 0, max_id));
        if (found == by_id_.end())
            fail_in_json(json_file_, reference.line, "no earlier value has this $id", "$ref");
        return found->second;
    }

    // Fills `made` and returns its $id, if any.
    std::optional<std::int64_t> read_object(const Json::Object& object, Description& made) {
        std::optional<std::int64_t> id;
        const Json* value = nullptr;
        const Json* number = nullptr;
        const Json* lines = nullptr;
        for (const auto& [name, json] : object) {
            if (!name.starts_with('$') || name.starts_with("$$"))
                continue;
            if (name == "$kind")
                made.kind = text(json, name);
            else if (name == "$id")
                id = integer(json, name, 0, max_id);
            else if (name == "$value")
                value = &json;
            else if (name == "$number")
                number = &json;
            else if (name == "$lines")
                lines = &json;
            else if (name == "$file" && tracked())
                made.where.file = files_[static_cast<std::size_t>(
                    integer(json, name, 0, static_cast<std::int64_t>(files_.size()) - 1))];
            else if (name == "$line" && tracked())
                made.where.line = line_number(json, name);
            else if (name != "$files" && name != "$file" && name != "$line")
                fail_in_json(json_file_, json.line,
                             "unknown name; names with $ have a meaning of ours", name);
        }
        if (id && by_id_.contains(*id))
            fail_in_json(json_file_, made.where.line, "two values have the same number", "$id");
        if (number != nullptr)
            made.data = special_number(*number);
        else if (value != nullptr)
            read_plain(*value, made, lines);
        else
            read_fields(object, made, lines);
        return id;
    }

    double special_number(const Json& json) const {
        const std::string& name = text(json, "$number");
        if (name == "nan")
            return std::numeric_limits<double>::quiet_NaN();
        if (name == "inf" || name == "-inf")
            return name == "inf" ? std::numeric_limits<double>::infinity()
                                 : -std::numeric_limits<double>::infinity();
        fail_in_json(json_file_, json.line, "expected nan, inf or -inf", "$number");
    }

    void read_fields(const Json::Object& object, Description& made, const Json* lines) {
        const auto* line_of = lines == nullptr ? nullptr : std::get_if<Json::Object>(&lines->data);
        std::map<std::string, int> known_lines;
        if (line_of != nullptr)
            for (const auto& [name, json] : *line_of)
                known_lines[name] = line_number(json, "$lines");
        Description::Table table;
        for (const auto& [key, json] : object) {
            if (key.starts_with('$') && !key.starts_with("$$"))
                continue;
            const std::string name = key.starts_with("$$") ? key.substr(1) : key;
            const auto known = known_lines.find(name);
            const int line = !tracked()                   ? json.line
                             : known != known_lines.end() ? known->second
                                                          : made.where.line;
            table[name] = {node(json, {made.where.file, line}), line};
        }
        made.data = std::move(table);
    }

    void read_plain(const Json& json, Description& made, const Json* lines) {
        if (const auto* array = std::get_if<Json::Array>(&json.data)) {
            const auto* line_of =
                lines == nullptr ? nullptr : std::get_if<Json::Array>(&lines->data);
            Description::List list;
            list.reserve(array->size());
            for (std::size_t i = 0; i < array->size(); ++i) {
                const int line = !tracked() ? (*array)[i].line
                                 : line_of != nullptr && i < line_of->size()
                                     ? line_number((*line_of)[i], "$lines")
                                     : made.where.line;
                list.push_back({node((*array)[i], {made.where.file, line}), line});
            }
            made.data = std::move(list);
        } else if (std::holds_alternative<Json::Object>(json.data)) {
            fail_in_json(json_file_, json.line, "expected a list or a plain value", "$value");
        } else {
            std::visit(
                [&](const auto& value) {
                    using T = std::decay_t<decltype(value)>;
                    if constexpr (!std::is_same_v<T, Json::Array> &&
                                  !std::is_same_v<T, Json::Object>)
                        made.data = value;
                },
                json.data);
        }
    }

    static constexpr std::int64_t max_id = std::numeric_limits<std::int64_t>::max();

    std::string json_file_;
    std::vector<std::string> files_;
    std::map<std::int64_t, DescriptionNode> by_id_;
};

} // namespace

DescriptionNode description_from_json(std::string_view text, const std::string& file) {
    return Reader(file).read(parse_json(text, file));
}

} // namespace scree
