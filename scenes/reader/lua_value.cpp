// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a Lua value to a tree of located nodes.
#include "core/utf8.h"
#include "scenes/reader/sandbox.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <lua.hpp>
#include <unordered_map>

namespace scree {

namespace {

constexpr int max_depth = 40; // usual scenes have less than 10
constexpr std::size_t max_mistakes = 100;
constexpr std::size_t longest_path = 60;

// Where a table is written in the script's source, if known.
struct Written {
    const SourceMap* map = nullptr;
    const TableSource* table = nullptr;

    const TableSource::Item* named(const std::string& name) const {
        return table == nullptr ? nullptr : table->named(name);
    }
    const TableSource::Item* positional(std::size_t index) const {
        return table == nullptr ? nullptr : table->positional(index);
    }
};

class Describer {
  public:
    Describer(lua_State* state, Sandbox& sandbox) : state_(state), sandbox_(sandbox) {}

    DescriptionNode run(const std::string& path) {
        DescriptionNode root = value(lua_gettop(state_), {path, 0}, {}, 0);
        if (!mistakes_.empty())
            throw Error(Fault::input, std::move(mistakes_));
        return root;
    }

  private:
    using Item = Description::Item;

    void mistake(const Location& where, std::string message) {
        if (mistakes_.size() < max_mistakes)
            mistakes_.push_back(
                {where,
                 path_.size() <= longest_path ? path_ : path_.substr(0, longest_path) + "...",
                 std::move(message),
                 {}});
    }

    DescriptionNode value(int index, const Location& where, const Written& written, int depth) {
        switch (lua_type(state_, index)) {
        case LUA_TBOOLEAN:
            return leaf(where, lua_toboolean(state_, index) != 0);
        case LUA_TNUMBER:
            return lua_isinteger(state_, index) != 0
                       ? leaf(where, std::int64_t{lua_tointeger(state_, index)})
                       : leaf(where, double{lua_tonumber(state_, index)});
        case LUA_TSTRING:
            return text(index, where);
        case LUA_TTABLE:
            return table(index, where, written, depth);
        case LUA_TNIL:
            return leaf(where, std::monostate{});
        default:
            mistake(where, fmt::format("a {} is not a value here",
                                       lua_isthread(state_, index) ? "coroutine"
                                                                   : luaL_typename(state_, index)));
            return leaf(where, std::monostate{});
        }
    }

    template <class T>
    DescriptionNode leaf(const Location& where, T data) {
        return std::make_shared<Description>(Description{where, {}, std::move(data)});
    }

    DescriptionNode text(int index, const Location& where) {
        std::size_t size = 0;
        const char* bytes = lua_tolstring(state_, index, &size);
        std::string out(bytes, size);
        if (!is_utf8(out))
            mistake(where, "this text is not UTF-8");
        return leaf(where, std::move(out));
    }

    DescriptionNode table(int index, const Location& where, const Written& written, int depth) {
        const void* identity = lua_topointer(state_, index);
        if (const auto known = known_.find(identity); known != known_.end()) {
            if (known->second == nullptr) {
                mistake(where, "this table contains itself");
                return leaf(where, std::monostate{});
            }
            return known->second;
        }
        if (depth == max_depth) {
            mistake(where, fmt::format("tables are nested more than {} deep", max_depth));
            return leaf(where, std::monostate{});
        }
        luaL_checkstack(state_, 10, nullptr);
        known_[identity] = nullptr;
        Description made{where, {}, {}};
        Written own = written;
        const std::string outer_path = path_;
        int numbers = 0;
        Names names;
        const bool keys_fine = read_keys(index, where, numbers, names);
        Tag tag;
        if (read_tag(state_, index, tag)) {
            path_ = made.kind = tag.kind;
            if (tag.place.file >= 0) {
                made.where = sandbox_.location(tag.place);
                const SourceMap& map = sandbox_.source_map(tag.place.file);
                own = {&map, map.find(tag.kind, tag.place.line, names)};
            }
        }
        if (keys_fine) {
            if (names.empty() && numbers > 0)
                made.data = list(index, numbers, made.where, own, depth);
            else
                made.data = fields(index, names, made.where, own, depth);
        }
        path_ = outer_path;
        return known_[identity] = std::make_shared<Description>(std::move(made));
    }

    using Names = std::vector<std::string>;

    // Reads the number of items 1, 2, ... and the sorted names; false when there are other keys.
    bool read_keys(int index, const Location& where, int& numbers, Names& names) {
        lua_Integer highest = 0;
        bool fine = true;
        lua_pushnil(state_);
        while (lua_next(state_, index) != 0) {
            lua_pop(state_, 1);
            if (lua_type(state_, -1) == LUA_TSTRING) {
                std::size_t size = 0;
                const char* bytes = lua_tolstring(state_, -1, &size);
                names.emplace_back(bytes, size);
                fine = fine && is_utf8(names.back());
            } else if (lua_isinteger(state_, -1) != 0 && lua_tointeger(state_, -1) >= 1) {
                highest = std::max(highest, lua_tointeger(state_, -1));
                ++numbers;
            } else {
                fine = false;
            }
        }
        std::sort(names.begin(), names.end());
        if (!fine)
            mistake(where, "fields need names, and lists count from 1");
        else if (numbers > 0 && !names.empty())
            mistake(where, fmt::format("has both named fields ({}) and items without a name",
                                       names.front()));
        else if (highest != numbers)
            mistake(where, fmt::format("item {} of this list is nil", first_gap(index)));
        else
            return true;
        return false;
    }

    lua_Integer first_gap(int index) {
        for (lua_Integer i = 1;; ++i) {
            const bool gap = lua_rawgeti(state_, index, i) == LUA_TNIL;
            lua_pop(state_, 1);
            if (gap)
                return i;
        }
    }

    // Pops the value on top of the stack; `at` is the item in the source, or null.
    Item item(const Location& holder, const SourceMap* map, const TableSource::Item* at,
              int depth) {
        const Location where{holder.file, at == nullptr ? holder.line : at->line};
        const Written inner{map, at == nullptr ? nullptr : map->at(at->table)};
        Item made{value(lua_gettop(state_), where, inner, depth + 1), where.line};
        lua_pop(state_, 1);
        return made;
    }

    Description::List list(int index, int count, const Location& where, const Written& written,
                           int depth) {
        Description::List out;
        out.reserve(static_cast<std::size_t>(count));
        const std::size_t length = path_.size();
        for (int i = 1; i <= count; ++i) {
            path_ += '[' + std::to_string(i) + ']';
            lua_rawgeti(state_, index, i);
            out.push_back(item(where, written.map,
                               written.positional(static_cast<std::size_t>(i - 1)), depth));
            path_.resize(length);
        }
        return out;
    }

    Description::Table fields(int index, const Names& names, const Location& where,
                              const Written& written, int depth) {
        Description::Table out;
        const std::size_t length = path_.size();
        for (const std::string& name : names) {
            path_ += (path_.empty() ? "" : ".") + name;
            lua_pushlstring(state_, name.data(), name.size());
            lua_rawget(state_, index);
            out[name] = item(where, written.map, written.named(name), depth);
            path_.resize(length);
        }
        return out;
    }

    lua_State* state_;
    Sandbox& sandbox_;
    std::string path_;
    std::vector<Diagnostic> mistakes_;
    std::unordered_map<const void*, DescriptionNode> known_; // null: in progress, to find cycles
};

} // namespace

DescriptionNode describe_value(lua_State* state, Sandbox& sandbox, const std::string& path) {
    return Describer(state, sandbox).run(path);
}

} // namespace scree
