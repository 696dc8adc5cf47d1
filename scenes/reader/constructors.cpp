// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that scene scripts call in addition to Lua's.
#include "scenes/reader/sandbox.h"

#include "core/display_encoding.h"
#include "core/file.h"
#include "geometry/plane/field.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <lua.hpp>
#include <new>

namespace scree {

namespace {

// A constructor's table carries a metatable { kind, file, line } marked by this address.
const char tag_mark = 0;

void push_mistake(lua_State* state, const Diagnostic& d) {
    const Sandbox& sandbox = Sandbox::of(state);
    // An error in an included file has its own location.
    const Place place = d.where.line > 0 ? sandbox.place_of(d.where) : sandbox.place(state);
    const std::string text =
        fmt::format("{}{}{}{}", Sandbox::prefix(place), d.path.empty() ? "" : d.path + ": ",
                    d.message, d.hint.empty() ? "" : "\n  " + d.hint);
    lua_pushlstring(state, text.data(), text.size());
}

// C++ exceptions must not pass through Lua, which is C: they are converted to Lua errors.
template <int (*body)(lua_State*)>
int guarded(lua_State* state) {
    try {
        return body(state);
    } catch (const Error& error) {
        push_mistake(state, error.diagnostics().front());
    } catch (const std::bad_alloc&) {
        lua_pushliteral(state, "not enough memory");
    }
    return lua_error(state);
}

bool is_tagged(lua_State* state, int index) {
    if (lua_type(state, index) != LUA_TTABLE || lua_getmetatable(state, index) == 0)
        return false;
    const bool tagged = lua_rawgetp(state, -1, &tag_mark) != LUA_TNIL;
    lua_pop(state, 2);
    return tagged;
}

std::string kind_of_value(lua_State* state, int index) {
    Tag tag;
    if (read_tag(state, index, tag))
        return "a " + tag.kind;
    switch (lua_type(state, index)) {
    case LUA_TNONE:
    case LUA_TNIL:
        return "nothing";
    case LUA_TSTRING:
        return fmt::format("the text \"{}\"", lua_tostring(state, index));
    default:
        return std::string("a ") + luaL_typename(state, index);
    }
}

// mesh.banana { ... }: a new table with the same fields, tagged with its kind and line.
int construct(lua_State* state) {
    const char* kind = lua_tostring(state, lua_upvalueindex(1));
    const int count = lua_gettop(state);
    if (count > 1 || (count == 1 && !lua_istable(state, 1)) || is_tagged(state, 1))
        throw Error(Diagnostic{
            {},
            {},
            fmt::format("{} takes one table, as in {} {{ ... }}; got {}", kind, kind,
                        count > 1 ? fmt::format("{} values", count) : kind_of_value(state, 1)),
            {}});
    lua_newtable(state);
    const int made = lua_gettop(state);
    if (count == 1) {
        lua_pushnil(state);
        while (lua_next(state, 1) != 0) {
            lua_pushvalue(state, -2);
            lua_insert(state, -2);
            lua_rawset(state, made);
        }
    }
    const Place place = Sandbox::of(state).place(state);
    lua_createtable(state, 3, 2);
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_rawseti(state, -2, 1);
    lua_pushinteger(state, place.file);
    lua_rawseti(state, -2, 2);
    lua_pushinteger(state, place.line);
    lua_rawseti(state, -2, 3);
    lua_pushboolean(state, 1);
    lua_rawsetp(state, -2, &tag_mark);
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_setfield(state, -2, "__name");
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_setmetatable(state, made);
    return 1;
}

// Upvalues: a constructor, and a function that may modify its result. There must be no C++ object
// here, since Lua errors leave by longjmp without running destructors.
int construct_and_finish(lua_State* state) {
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_insert(state, 1);
    lua_call(state, lua_gettop(state) - 1, 1);
    lua_pushvalue(state, lua_upvalueindex(2));
    lua_pushvalue(state, 1);
    lua_call(state, 1, 0);
    return 1;
}

// scree_constructor(kind, finish or nil)
int make_constructor(lua_State* state) {
    luaL_checkstring(state, 1);
    lua_settop(state, 2);
    lua_pushvalue(state, 1);
    lua_pushcclosure(state, guarded<construct>, 1);
    if (lua_isnil(state, 2))
        return 1;
    lua_pushvalue(state, 2);
    lua_pushcclosure(state, construct_and_finish, 2);
    return 1;
}

// Samples along the longer side of a field.function: default, minimum, maximum.
int function_samples(lua_State* state) {
    lua_pushinteger(state, FunctionSamples::usual);
    lua_pushinteger(state, FunctionSamples::least);
    lua_pushinteger(state, FunctionSamples::most);
    return 3;
}

// families() -> list of the families whose members are constructors
int families(lua_State* state) {
    const std::vector<std::string>& names = Sandbox::of(state).families();
    lua_createtable(state, static_cast<int>(names.size()), 0);
    for (std::size_t i = 0; i < names.size(); ++i) {
        lua_pushlstring(state, names[i].data(), names[i].size());
        lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

// nearest(prefix, name, {names}) -> "\n  did you mean math.floor?" or ""
int nearest(lua_State* state) {
    std::vector<std::string> known;
    for (lua_Integer i = 1; lua_rawgeti(state, 3, i) == LUA_TSTRING; ++i) {
        known.emplace_back(lua_tostring(state, -1));
        lua_pop(state, 1);
    }
    const std::string name = nearest_name(lua_tostring(state, 2), known);
    lua_pushstring(
        state, name.empty()
                   ? ""
                   : fmt::format("\n  did you mean {}{}?", lua_tostring(state, 1), name).c_str());
    return 1;
}

std::string text_argument(lua_State* state, int index, const char* usage) {
    if (lua_type(state, index) != LUA_TSTRING)
        throw Error(fmt::format("expected {}, got {}", usage, kind_of_value(state, index)));
    std::size_t size = 0;
    const char* text = lua_tolstring(state, index, &size);
    return {text, size};
}

template <class T>
bool parse(const std::string& text, T& value) {
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    return code == std::errc{} && end == text.data() + text.size();
}

// Pushes the override, converted to the type of the default.
void push_override(lua_State* state, const std::string& name, const std::string& given) {
    const auto mistake = [&](const std::string& expected) {
        return Error(Diagnostic{
            {}, "--set " + name, fmt::format("expected {}, got {}", expected, given), {}});
    };
    switch (lua_type(state, 2)) {
    case LUA_TNONE:
    case LUA_TNIL:
    case LUA_TSTRING:
        lua_pushlstring(state, given.data(), given.size());
        break;
    case LUA_TBOOLEAN:
        if (given != "true" && given != "false")
            throw mistake("true or false");
        lua_pushboolean(state, given == "true" ? 1 : 0);
        break;
    case LUA_TNUMBER: {
        lua_Integer integer = 0;
        double number = 0;
        if (parse(given, integer))
            lua_pushinteger(state, integer);
        else if (parse(given, number) && std::isfinite(number))
            lua_pushnumber(state, number);
        else
            throw mistake("a number");
        break;
    }
    default:
        break; // rejected by `arg` already
    }
}

int arg(lua_State* state) {
    const std::string name = text_argument(state, 1, "arg(\"name\", default)");
    lua_settop(state, 2);
    const int type = lua_type(state, 2);
    if (type != LUA_TNIL && type != LUA_TSTRING && type != LUA_TBOOLEAN && type != LUA_TNUMBER)
        throw Error(fmt::format("the default of arg(\"{}\", ...) must be a number, a text, true or "
                                "false, not {}",
                                name, kind_of_value(state, 2)));
    const std::string* given = Sandbox::of(state).override_of(name);
    if (given != nullptr)
        push_override(state, name, *given);
    else if (lua_isnil(state, 2))
        throw Error(Diagnostic{{},
                               {},
                               fmt::format("arg(\"{}\") has no default and was not given", name),
                               fmt::format("give it with --set {}=...", name)});
    return 1;
}

std::string include_path(lua_State* state, Sandbox& sandbox) {
    const std::string name = text_argument(state, 1, "include(\"file.lua\")");
    const Place place = sandbox.place(state);
    std::string path =
        resolve_path(name, place.file < 0 ? std::string{} : sandbox.file(place.file));
    sandbox.check_may_include(path);
    return path;
}

int begin_include(lua_State* state) {
    Sandbox& sandbox = Sandbox::of(state);
    const std::string path = include_path(state, sandbox);
    if (const auto known = sandbox.includes.find(path); known != sandbox.includes.end()) {
        if (known->second.open) {
            std::string chain;
            bool inside = false;
            for (const std::string& open : sandbox.open_files) {
                inside = inside || open == path;
                if (inside)
                    chain += file_name(open) + " -> ";
            }
            throw Error(fmt::format("the files include each other: {}{}", chain, file_name(path)));
        }
        lua_rawgeti(state, LUA_REGISTRYINDEX, known->second.value);
        return 1;
    }
    sandbox.load(state, path);
    sandbox.includes[path] = {};
    sandbox.open_files.push_back(path);
    return 2; // a second value means that the script must still be run
}

// `include` is split into parts so that no C++ object is alive while the other script runs, since
// its errors leave by longjmp.
int include(lua_State* state) {
    lua_settop(state, 1);
    lua_pushcfunction(state, guarded<begin_include>);
    lua_pushvalue(state, 1);
    // begin_include is a C function too: the innermost script line is still the call of include.
    lua_call(state, 1, LUA_MULTRET);
    if (lua_gettop(state) == 2)
        return 1;
    lua_settop(state, 3);
    lua_call(state, 0, 1);
    lua_pushvalue(state, -1);
    const int reference = luaL_ref(state, LUA_REGISTRYINDEX);
    Sandbox& sandbox = Sandbox::of(state);
    sandbox.includes[sandbox.open_files.back()] = {reference, false};
    sandbox.open_files.pop_back();
    return 1;
}

int srgb(lua_State* state) {
    const std::string text = text_argument(state, 1, "srgb(\"#c8a060\")");
    unsigned value = 0;
    const auto [end, code] = std::from_chars(text.data() + std::min<std::size_t>(1, text.size()),
                                             text.data() + text.size(), value, 16);
    if (text.size() != 7 || text[0] != '#' || code != std::errc{} ||
        end != text.data() + text.size())
        throw Error(fmt::format("expected a colour like srgb(\"#c8a060\"), got \"{}\"", text));
    lua_createtable(state, 3, 0);
    for (int i = 0; i < 3; ++i) {
        const double encoded = double(value >> (16 - 8 * i) & 0xFFU) / 255.0;
        lua_pushnumber(state, linear_from_display(encoded));
        lua_rawseti(state, -2, i + 1);
    }
    return 1;
}

template <int divisor>
int length(lua_State* state) {
    if (lua_type(state, 1) != LUA_TNUMBER)
        throw Error(fmt::format("expected a number, got {}", kind_of_value(state, 1)));
    lua_pushnumber(state, lua_tonumber(state, 1) / divisor);
    return 1;
}

int print(lua_State* state) {
    std::string line;
    for (int i = 1; i <= lua_gettop(state); ++i)
        line += (i > 1 ? "\t" : "") + text_argument(state, i, "a text");
    Sandbox::of(state).print(line + "\n");
    return 0;
}

} // namespace

bool read_tag(lua_State* state, int index, Tag& tag) {
    if (!is_tagged(state, index))
        return false;
    lua_getmetatable(state, index);
    lua_rawgeti(state, -1, 1);
    lua_rawgeti(state, -2, 2);
    lua_rawgeti(state, -3, 3);
    tag.kind = lua_tostring(state, -3);
    tag.place = {static_cast<int>(lua_tointeger(state, -2)),
                 static_cast<int>(lua_tointeger(state, -1))};
    lua_pop(state, 4);
    return true;
}

void add_scene_functions(lua_State* state) {
    lua_register(state, "scree_constructor", make_constructor);
    lua_register(state, "scree_nearest", guarded<nearest>);
    lua_register(state, "scree_samples", function_samples);
    lua_register(state, "scree_families", families);
    lua_register(state, "arg", guarded<arg>);
    lua_register(state, "include", include);
    lua_register(state, "srgb", guarded<srgb>);
    lua_register(state, "mm", guarded<length<1000>>);
    lua_register(state, "cm", guarded<length<100>>);
    lua_register(state, "deg", guarded<length<1>>);
    lua_register(state, "print", guarded<print>);
}

} // namespace scree
