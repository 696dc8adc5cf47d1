// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/json.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

namespace scree {

namespace {

constexpr std::size_t max_depth = 100; // real scenes stay below 10; keeps recursion small

// A JSON value with its line.
struct Json {
    using Array = std::vector<Json>;
    using Object = std::vector<std::pair<std::string, Json>>;

    int line = 0;
    std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object> data;
};

[[noreturn]] void fail(const std::string& file, int line, std::string message,
                       std::string path = {}) {
    throw Error(Diagnostic{{file, line}, std::move(path), std::move(message), {}});
}

// Feeds the parser and counts the lines that it has read.
struct LineCounter {
    int line = 1;
    bool after_newline = false;
};

class CountingIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, LineCounter* counter) : at_(at), counter_(counter) {}

    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        counter_->after_newline = *at_ == '\n';
        if (counter_->after_newline)
            ++counter_->line;
        ++at_;
        return *this;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
        return a.at_ == b.at_;
    }
    friend bool operator!=(const CountingIterator& a, const CountingIterator& b) {
        return a.at_ != b.at_;
    }

  private:
    const char* at_;
    LineCounter* counter_;
};

// Builds Json values from the parser's events.
class Builder final : public nlohmann::json_sax<nlohmann::json> {
  public:
    Builder(std::string file, const LineCounter& counter)
        : file_(std::move(file)), counter_(counter) {}

    Json root;

    bool null() override { return add(std::monostate{}); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(std::int64_t{value}); }
    bool number_unsigned(number_unsigned_t value) override {
        if (value > std::uint64_t(std::numeric_limits<std::int64_t>::max()))
            return add(static_cast<double>(value));
        return add(static_cast<std::int64_t>(value));
    }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::Object{}); }
    bool start_array(std::size_t) override { return open(Json::Array{}); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        if (!names_.back().insert(name).second)
            fail(file_, line(), "\"" + name + "\" appears twice");
        keys_.back() = std::move(name);
        return true;
    }

    bool parse_error(std::size_t, const std::string&,
                     const nlohmann::json::exception& error) override {
        // "[json.exception...] parse error at line 1, column 2: syntax error while ...: what"
        std::string message = error.what();
        const std::size_t what = message.find(" - ");
        const std::size_t other = message.find(": ", message.find("column"));
        message = what != std::string::npos    ? message.substr(what + 3)
                  : other != std::string::npos ? message.substr(other + 2)
                                               : message;
        fail(file_, line(), "this is not JSON: " + message.substr(0, message.find("; last read")));
    }

  private:
    int line() const { return counter_.line - (counter_.after_newline ? 1 : 0); }

    template <class T>
    bool add(T value) {
        place(Json{line(), std::move(value)});
        return true;
    }

    Json* place(Json value) {
        if (open_.empty()) {
            root = std::move(value);
            return &root;
        }
        if (auto* array = std::get_if<Json::Array>(&open_.back()->data))
            return &array->emplace_back(std::move(value));
        auto& object = std::get<Json::Object>(open_.back()->data);
        return &object.emplace_back(keys_.back(), std::move(value)).second;
    }

    template <class T>
    bool open(T container) {
        if (open_.size() == max_depth)
            fail(file_, line(), fmt::format("values are nested more than {} deep", max_depth));
        open_.push_back(place(Json{line(), std::move(container)}));
        keys_.emplace_back();
        names_.emplace_back();
        return true;
    }

    bool close() {
        open_.pop_back();
        keys_.pop_back();
        names_.pop_back();
        return true;
    }

    std::string file_;
    const LineCounter& counter_;
    // A container does not grow while one of its members is open, so the pointers stay good.
    std::vector<Json*> open_;
    std::vector<std::string> keys_;
    std::vector<std::set<std::string>> names_;
};

// Turns Json into nodes.
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
            fail(json_file_, json.line, "expected a list of file names", "$files");
        for (const Json& name : *array) {
            if (!std::holds_alternative<std::string>(name.data))
                fail(json_file_, name.line, "expected a list of file names", "$files");
            files_.push_back(std::get<std::string>(name.data));
        }
    }

    std::int64_t integer(const Json& json, const std::string& path, std::int64_t min,
                         std::int64_t max) const {
        const auto* value = std::get_if<std::int64_t>(&json.data);
        if (value == nullptr || *value < min || *value > max)
            fail(json_file_, json.line,
                 fmt::format("expected a whole number from {} to {}", min, max), path);
        return *value;
    }

    int line_number(const Json& json, const std::string& path) const {
        return static_cast<int>(integer(json, path, 0, std::numeric_limits<int>::max()));
    }

    const std::string& text(const Json& json, const std::string& path) const {
        const auto* value = std::get_if<std::string>(&json.data);
        if (value == nullptr)
            fail(json_file_, json.line, "expected a text", path);
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
            fail(json_file_, reference.line, "stands with other fields", "$ref");
        const auto found = by_id_.find(integer(reference, "$ref", 0, max_id));
        if (found == by_id_.end())
            fail(json_file_, reference.line, "no earlier value has this $id", "$ref");
        return found->second;
    }

    // Fills `made`; the answer is its $id.
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
                fail(json_file_, json.line, "unknown name; names with $ have a meaning of ours",
                     name);
        }
        if (id && by_id_.contains(*id))
            fail(json_file_, made.where.line, "two values have the same number", "$id");
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
        fail(json_file_, json.line, "expected nan, inf or -inf", "$number");
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
            fail(json_file_, json.line, "expected a list or a plain value", "$value");
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
    LineCounter counter;
    Builder builder(file, counter);
    const CountingIterator begin(text.data(), &counter);
    const CountingIterator end(text.data() + text.size(), &counter);
    if (!nlohmann::json::sax_parse(begin, end, &builder))
        fail(file, counter.line, "this is not JSON");
    return Reader(file).read(builder.root);
}

} // namespace scree
