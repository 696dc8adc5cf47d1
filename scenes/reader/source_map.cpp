// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/source_map.h"

#include "scenes/reader/lua_lexer.h"

#include <algorithm>

namespace scree {

const TableSource::Item* TableSource::named(std::string_view name) const {
    // The last of several equal names is used, as in Lua.
    const auto after = std::ranges::upper_bound(
        by_name, name, {}, [&](std::size_t i) { return std::string_view(items[i].name); });
    if (after == by_name.begin() || items[after[-1]].name != name)
        return nullptr;
    return &items[after[-1]];
}

const TableSource::Item* TableSource::positional(std::size_t index) const {
    return index < in_order.size() ? &items[in_order[index]] : nullptr;
}

namespace {

using Tokens = std::vector<LuaToken>;

constexpr int most_on_a_line = 100;

bool opens_block(const LuaToken& token) {
    return token.is("function") || token.is("if") || token.is("do") || token.is("repeat");
}

bool closes(const LuaToken& token) {
    return token.is("}") || token.is(")") || token.is("]") || token.is("end") || token.is("until");
}

// Finds the dotted name before the token `brace`, optionally followed by one parenthesis.
void find_callee(const Tokens& tokens, std::size_t brace, TableSource& table) {
    std::size_t at = brace;
    if (at > 0 && tokens[at - 1].is("("))
        --at;
    std::size_t first = at;
    while (first > 0 && tokens[first - 1].type == LuaToken::Type::name) {
        --first;
        if (first == 0 || !tokens[first - 1].is("."))
            break;
        --first;
    }
    for (std::size_t i = first; i < at; ++i)
        table.callee += tokens[i].text;
    table.callee_line = tokens[first].line;
}

void index_items(TableSource& table) {
    for (std::size_t i = 0; i < table.items.size(); ++i)
        (table.items[i].name.empty() ? table.in_order : table.by_name).push_back(i);
    std::ranges::stable_sort(table.by_name, {},
                             [&](std::size_t i) { return std::string_view(table.items[i].name); });
}

// Finds the tables in one pass over the tokens, with a stack of open brackets and blocks.
class TableFinder {
  public:
    explicit TableFinder(const Tokens& tokens) : tokens_(tokens) {}

    std::vector<TableSource> run() {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            const LuaToken& token = tokens_[i];
            if (in_table() && (token.is(",") || token.is(";"))) {
                open_.back().between_items = true;
                continue;
            }
            if (in_table() && open_.back().between_items && !token.is("}"))
                begin_item(i);
            if (token.is("{"))
                open_table(i);
            else if (token.is("(") || token.is("[") || opens_block(token))
                open_.push_back({});
            else if (closes(token) && !open_.empty())
                open_.pop_back();
        }
        std::ranges::for_each(tables_, index_items);
        return std::move(tables_);
    }

  private:
    struct Open {
        int table = -1; // -1: a parenthesis, bracket or block
        bool between_items = false;
        std::size_t value = 0; // first token of the current item's value
    };

    bool in_table() const { return !open_.empty() && open_.back().table >= 0; }

    bool token_is(std::size_t i, std::string_view text) const {
        return i < tokens_.size() && tokens_[i].is(text);
    }

    void begin_item(std::size_t i) {
        Open& open = open_.back();
        open.between_items = false;
        open.value = i;
        TableSource::Item item;
        item.line = tokens_[i].line;
        if (tokens_[i].type == LuaToken::Type::name && token_is(i + 1, "=")) {
            item.name = tokens_[i].text;
            open.value = i + 2;
        } else if (tokens_[i].is("[") && token_is(i + 2, "]") && token_is(i + 3, "=")) {
            item.name = tokens_[i + 1].text;
            open.value = i + 4;
        }
        tables_[static_cast<std::size_t>(open.table)].items.push_back(std::move(item));
    }

    void open_table(std::size_t i) {
        const int index = static_cast<int>(tables_.size());
        if (in_table() && open_.back().value == i)
            tables_[static_cast<std::size_t>(open_.back().table)].items.back().table = index;
        TableSource& table = tables_.emplace_back();
        table.line = tokens_[i].line;
        find_callee(tokens_, i, table);
        open_.push_back({.table = index, .between_items = true});
    }

    const Tokens& tokens_;
    std::vector<Open> open_;
    std::vector<TableSource> tables_;
};

} // namespace

SourceMap::SourceMap(std::string_view source) : tables_(TableFinder(lex_lua(source)).run()) {
    for (std::size_t i = 0; i < tables_.size(); ++i) {
        by_line_.emplace(tables_[i].line, i);
        if (tables_[i].callee_line != tables_[i].line)
            by_line_.emplace(tables_[i].callee_line, i);
    }
}

const TableSource* SourceMap::find(std::string_view kind, int line,
                                   const std::vector<std::string>& names) const {
    const TableSource* best = nullptr;
    std::ptrdiff_t best_score = 0;
    const auto [begin, end] = by_line_.equal_range(line);
    int seen = 0;
    for (auto entry = begin; entry != end; ++entry) {
        if (++seen > most_on_a_line)
            return nullptr;
        const TableSource& table = tables_[entry->second];
        const auto shared = std::count_if(names.begin(), names.end(), [&](const std::string& name) {
            return table.named(name) != nullptr;
        });
        // A call under another name (local m = mesh.box) matches only if it has all the fields.
        const bool same_name = table.callee == kind;
        if (!same_name && (table.callee.empty() || shared != std::ssize(names)))
            continue;
        const std::ptrdiff_t score =
            1 + (same_name ? 1000 : 0) + 10 * shared - std::ssize(table.items);
        if (best == nullptr || score > best_score) {
            best = &table;
            best_score = score;
        }
    }
    return best;
}

} // namespace scree
