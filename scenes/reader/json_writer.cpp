// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/description.h"

#include <cmath>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <unordered_map>

namespace scree {

namespace {

using List = Description::List;
using Table = Description::Table;

bool is_leaf(const Description& node) {
    return !std::holds_alternative<List>(node.data) && !std::holds_alternative<Table>(node.data);
}

template <class Visit>
void for_each_child(const Description& node, const Visit& visit) {
    if (const auto* list = std::get_if<List>(&node.data))
        for (const Description::Item& item : *list)
            visit(item);
    else if (const auto* table = std::get_if<Table>(&node.data))
        for (const auto& [name, item] : *table)
            visit(item);
}

class Writer {
  public:
    explicit Writer(JsonStyle style) : style_(style) {}

    std::string write(const Description& root) {
        count_uses(root);
        if (style_.locations)
            collect_files(root);
        node(root, Location{}, true);
        return std::move(out_);
    }

  private:
    void count_uses(const Description& of) {
        if (!is_leaf(of) && ++uses_[&of] == 1)
            for_each_child(of, [&](const Description::Item& item) { count_uses(*item.value); });
    }

    void collect_files(const Description& root) {
        for (const auto& [used, count] : uses_)
            files_.emplace(used->where.file, 0);
        files_.emplace(root.where.file, 0);
        int next = 0; // files are numbered in alphabetical order, so deterministically
        for (auto& [name, index] : files_)
            index = next++;
    }

    // `inherited` is the location that a reader assumes for the node by default.
    void node(const Description& of, const Location& inherited, bool is_root = false) {
        const bool elsewhere = of.where.file != inherited.file || of.where.line != inherited.line;
        if (is_leaf(of) && of.kind.empty() && !(style_.locations && (is_root || elsewhere)))
            return leaf(of); // the most common case
        const auto use = uses_.find(&of);
        const bool shared = use != uses_.end() && use->second > 1;
        if (shared) {
            const auto [entry, first] = ids_.emplace(&of, ids_.size() + 1);
            if (!first) {
                out_ += fmt::format("{{\"$ref\": {}}}", entry->second);
                return;
            }
        }
        const auto* table = std::get_if<Table>(&of.data);
        open('{');
        if (!of.kind.empty())
            member("$kind", quoted(of.kind));
        if (shared)
            member("$id", std::to_string(ids_.at(&of)));
        if (style_.locations)
            location(of, inherited, is_root);
        if (table != nullptr) {
            for (const auto& [name, item] : *table) {
                member(name.starts_with('$') ? "$" + name : name, "");
                node(*item.value, {of.where.file, item.line});
            }
            close('}');
        } else if (!fields_.back()) { // no $ names were written, so plain JSON is enough
            drop_open();
            plain(of);
        } else {
            member("$value", "");
            plain(of);
            close('}');
        }
    }

    void location(const Description& of, const Location& inherited, bool is_root) {
        if (is_root) {
            std::string names;
            for (const auto& [name, index] : files_)
                names += (names.empty() ? "" : ", ") + quoted(name);
            member("$files", "[" + names + "]");
        }
        if (is_root || of.where.file != inherited.file)
            member("$file", std::to_string(files_.at(of.where.file)));
        if (of.where.line != inherited.line)
            member("$line", std::to_string(of.where.line));
        lines(of);
    }

    void lines(const Description& of) {
        std::string text;
        if (const auto* table = std::get_if<Table>(&of.data)) {
            for (const auto& [name, item] : *table)
                if (item.line != of.where.line)
                    text +=
                        fmt::format("{}{}: {}", text.empty() ? "" : ", ", quoted(name), item.line);
            if (!text.empty())
                member("$lines", "{" + text + "}");
        } else if (const auto* list = std::get_if<List>(&of.data)) {
            bool differ = false;
            for (const Description::Item& item : *list) {
                differ = differ || item.line != of.where.line;
                text += fmt::format("{}{}", text.empty() ? "" : ", ", item.line);
            }
            if (differ)
                member("$lines", "[" + text + "]");
        }
    }

    void plain(const Description& of) {
        if (const auto* list = std::get_if<List>(&of.data)) {
            bool inline_list = true;
            for (const Description::Item& item : *list)
                inline_list = inline_list && is_leaf(*item.value);
            const bool indent = style_.indent;
            style_.indent = indent && !inline_list;
            open('[');
            for (const Description::Item& item : *list) {
                separate();
                node(*item.value, {of.where.file, item.line});
            }
            close(']');
            style_.indent = indent;
        } else {
            leaf(of);
        }
    }

    void leaf(const Description& of) {
        if (const auto* flag = std::get_if<bool>(&of.data))
            out_ += *flag ? "true" : "false";
        else if (const auto* integer = std::get_if<std::int64_t>(&of.data))
            out_ += std::to_string(*integer);
        else if (const auto* number = std::get_if<double>(&of.data))
            real(*number);
        else if (const auto* text = std::get_if<std::string>(&of.data))
            out_ += quoted(*text);
        else
            out_ += "null";
    }

    void real(double value) {
        if (std::isnan(value))
            out_ += R"({"$number": "nan"})";
        else if (std::isinf(value))
            out_ += value > 0 ? R"({"$number": "inf"})" : R"({"$number": "-inf"})";
        else {
            // The shortest text that reads back to the same bits, and not to an integer.
            const std::string text = fmt::format("{}", value);
            out_ += text;
            if (text.find_first_of(".e") == std::string::npos)
                out_ += ".0";
        }
    }

    static std::string quoted(const std::string& text) {
        return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    }

    void open(char bracket) {
        opened_at_ = out_.size();
        out_ += bracket;
        fields_.push_back(false);
    }

    void drop_open() {
        out_.resize(opened_at_);
        fields_.pop_back();
    }

    void close(char bracket) {
        const bool empty = !fields_.back();
        fields_.pop_back();
        if (!empty)
            new_line();
        out_ += bracket;
    }

    void separate() {
        if (fields_.back())
            out_ += style_.indent ? "," : ", ";
        fields_.back() = true;
        new_line();
    }

    void new_line() {
        if (style_.indent)
            out_ += "\n" + std::string(fields_.size(), ' ');
    }

    void member(const std::string& name, const std::string& value) {
        separate();
        out_ += quoted(name) + ": " + value;
    }

    JsonStyle style_;
    std::string out_;
    std::vector<bool> fields_; // for each open bracket: whether it has a member
    std::size_t opened_at_ = 0;
    std::map<std::string, int> files_;
    std::unordered_map<const Description*, int> uses_;
    std::unordered_map<const Description*, std::size_t> ids_;
};

} // namespace

std::string to_json(const Description& description, JsonStyle style) {
    return Writer(style).write(description);
}

} // namespace scree
