// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/sandbox.h"

#include "core/file.h"
#include "scenes/reader/confinement.h"
#include "scenes/reader/hidden_names.h"
#include "scenes/reader/json.h"
#include "scenes/reader/lua_lexer.h"

#include <algorithm>
#include <clocale>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <lua.hpp>
#include <new>
#include <nlohmann/json.hpp>
#include <sys/time.h>
#include <unistd.h>

namespace scree {

namespace {

constexpr int instructions_between_checks = 200; // few enough to report the right loop
constexpr std::size_t max_printed = std::size_t{1} << 20;
constexpr std::uint64_t largest_script = std::uint64_t{16} << 20;
// Allocations may exceed the limit briefly, since a full garbage collection runs before the error.
constexpr std::size_t memory_reserve = std::size_t{16} << 20;

// State shared by the hooks, the allocator and the signal handler. There is one sandbox per
// process.
struct Watch {
    const Channel* channel = nullptr;
    const Sandbox* sandbox = nullptr;
    lua_State* main_state = nullptr;
    std::size_t memory_limit = 0;
    std::size_t memory_used = 0;
    Place place; // last known place of the script
    volatile std::sig_atomic_t expired = 0;
};
Watch watch;

[[noreturn]] void end_at_limit(char message, Place place) {
    watch.channel->send(message, {reinterpret_cast<const char*>(&place), sizeof place});
    _exit(0);
}

// While an error unwinds the stack no script is on it; then the last known place is kept.
void see(Place place) {
    if (place.file >= 0)
        watch.place = place;
}

void* allocate(void*, void* old, std::size_t old_size, std::size_t size) {
    const std::size_t freed = old == nullptr ? 0 : old_size;
    if (size == 0) {
        std::free(old);
        watch.memory_used -= freed;
        return nullptr;
    }
    if (size > freed && watch.memory_used - freed + size > watch.memory_limit + memory_reserve) {
        // The main state is always valid; while a coroutine runs its line is that of the resume.
        if (watch.main_state != nullptr)
            see(watch.sandbox->place(watch.main_state));
        return nullptr;
    }
    void* block = std::realloc(old, size);
    if (block != nullptr)
        watch.memory_used += size - freed;
    return block;
}

// On the first tick the hook ends the script at its exact line. A second tick means that the script
// is stuck in a C function, where hooks do not run.
void on_timer(int) {
    if (watch.expired != 0)
        end_at_limit(ScriptMessage::time, watch.place);
    watch.expired = 1;
}

void start_timer(double seconds) {
    struct sigaction action {};
    action.sa_handler = on_timer;
    sigaction(SIGPROF, &action, nullptr);
    const auto whole = std::floor(seconds);
    const itimerval timer{
        .it_interval = {0, 100'000},
        .it_value = {static_cast<time_t>(whole),
                     std::max<suseconds_t>(1, static_cast<suseconds_t>((seconds - whole) * 1e6))}};
    setitimer(ITIMER_PROF, &timer, nullptr);
}

void stop_timer() {
    const itimerval none{};
    setitimer(ITIMER_PROF, &none, nullptr);
}

void on_hook(lua_State* state, lua_Debug* event) {
    if (event->event == LUA_HOOKCALL || event->event == LUA_HOOKTAILCALL) {
        // Only calls of C functions matter, since no other hook runs inside them.
        lua_getinfo(state, "S", event);
        if (event->what[0] == 'C')
            see(watch.sandbox->place(state));
        return;
    }
    see(watch.sandbox->place(state));
    if (watch.expired != 0)
        end_at_limit(ScriptMessage::time, watch.place);
    if (watch.memory_used > watch.memory_limit) {
        lua_gc(state, LUA_GCCOLLECT);
        if (watch.memory_used > watch.memory_limit)
            end_at_limit(ScriptMessage::memory, watch.place);
    }
}

// The file with index 3 is named "@#3" in Lua, which truncates long names.
int file_of(const char* source) {
    return source[0] == '@' && source[1] == '#' ? std::atoi(source + 2) : -1;
}

// Message handler: adds the location to a message before the stack is unwound.
int add_place(lua_State* state) {
    if (lua_type(state, 1) != LUA_TSTRING) {
        lua_pushfstring(state, "the script raised an error that is not a text but a %s",
                        luaL_typename(state, 1));
        lua_replace(state, 1);
    }
    const Place place = Sandbox::of(state).place(state);
    const char* message = lua_tostring(state, 1);
    const bool has_place = message[0] == '#' && message[1] >= '0' && message[1] <= '9';
    if (!has_place && place.file >= 0) {
        // Lines of the prelude mean nothing to users.
        if (std::strncmp(message, "scree:", 6) == 0 && std::strchr(message + 6, ' ') != nullptr)
            message = std::strchr(message + 6, ' ') + 1;
        lua_pushfstring(state, "#%d:%d: %s", place.file, place.line, message);
    } else {
        lua_pushvalue(state, 1);
    }
    return 1;
}

// `function` is not a valid name in Lua, so field.function is rewritten to field.Function (see
// prelude.cpp).
std::string with_lua_names(const std::string& source) {
    std::string out = source;
    const std::vector<LuaToken> tokens = lex_lua(source);
    for (std::size_t i = 2; i < tokens.size(); ++i)
        if (tokens[i].text == "function" && tokens[i - 1].is(".") && tokens[i - 2].text == "field")
            out[static_cast<std::size_t>(tokens[i].text.data() - source.data())] = 'F';
    return out;
}

// Where links lead to counts.
bool lies_in(const std::string& path, const std::string& folder) {
    std::error_code code;
    const auto inner = std::filesystem::weakly_canonical(path, code);
    const auto outer = std::filesystem::canonical(folder, code);
    if (code)
        return false;
    const auto [end, rest] = std::ranges::mismatch(outer, inner);
    return end == outer.end();
}

std::string mistakes_json(const std::vector<Diagnostic>& diagnostics) {
    nlohmann::json list = nlohmann::json::array();
    for (const Diagnostic& d : diagnostics)
        list.push_back({d.where.file, d.where.line, d.path, d.message, d.hint});
    return list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace

Sandbox::Sandbox(const Channel& channel, const ScriptOptions& options)
    : channel_(channel), options_(options) {
    watch.channel = &channel;
    watch.sandbox = this;
    watch.memory_limit = options.limits.memory;
    std::setlocale(LC_ALL, "C"); // affects number formatting and string comparison
    state_ = lua_newstate(allocate, nullptr);
    if (state_ == nullptr)
        end_at_limit(ScriptMessage::memory, {});
    *static_cast<Sandbox**>(lua_getextraspace(state_)) = this;
    watch.main_state = state_;
}

// The Lua state is not closed: the process ends anyway, and closing a full heap takes long.
Sandbox::~Sandbox() = default;

Sandbox& Sandbox::of(lua_State* state) {
    return **static_cast<Sandbox**>(lua_getextraspace(state));
}

Place Sandbox::place(lua_State* state) const {
    lua_Debug info;
    for (int level = 0; level < 50 && lua_getstack(state, level, &info) != 0; ++level) {
        lua_getinfo(state, "Sl", &info);
        if (const int file = file_of(info.source); file >= 0 && info.currentline > 0)
            return {file, info.currentline};
    }
    return {};
}

Location Sandbox::location(Place place) const {
    const bool known = place.file >= 0 && place.file < static_cast<int>(files_.size());
    return known ? Location{file(place.file), place.line}
                 : Location{files_.empty() ? "" : files_.front(), 0};
}

Place Sandbox::place_of(const Location& where) const {
    for (std::size_t i = 0; i < files_.size(); ++i)
        if (files_[i] == where.file)
            return {static_cast<int>(i), where.line};
    return {};
}

std::string Sandbox::prefix(Place place) {
    return place.file < 0 ? std::string{} : fmt::format("#{}:{}: ", place.file, place.line);
}

const SourceMap& Sandbox::source_map(int index) {
    const auto found = source_maps_.find(index);
    if (found != source_maps_.end())
        return found->second;
    return source_maps_.emplace(index, SourceMap(sources_[static_cast<std::size_t>(index)]))
        .first->second;
}

std::vector<std::string> Sandbox::readable_folders(const std::string& scene) const {
    std::vector<std::string> folders = options_.readable_folders;
    folders.push_back(folder_of(scene));
    return folders;
}

void Sandbox::check_may_include(const std::string& path) const {
    if (extension(path) != "lua")
        throw Error(path + ": is not a script; expected a name that ends in .lua");
    if (std::ranges::none_of(readable_folders(files_.front()),
                             [&](const auto& folder) { return lies_in(path, folder); }))
        throw Error(Diagnostic{{},
                               {},
                               path + ": lies outside of the scene's folder",
                               "--allow-read " + folder_of(path) + " lets the script read there"});
}

void Sandbox::load(lua_State* state, const std::string& path) {
    sources_.push_back(read_file(path, largest_script));
    const int index = static_cast<int>(files_.size());
    files_.push_back(path);
    channel_.send(ScriptMessage::file, path);
    const std::string compilable = with_lua_names(sources_.back());
    std::string_view source = compilable;
    if (source.starts_with("#")) // skipped by lua too, for #!
        source.remove_prefix(std::min(source.find('\n'), source.size()));
    const std::string name = fmt::format("@#{}", index);
    if (luaL_loadbufferx(state, source.data(), source.size(), name.c_str(), "t") == LUA_OK)
        return;
    const LuaMessage message = parse_lua_message(luaL_tolstring(state, -1, nullptr), {index, 0});
    throw Error(Diagnostic{location(message.place), {}, plain_words(message.text), message.hint});
}

const std::string* Sandbox::override_of(const std::string& name) {
    asked_.insert(name);
    const auto found = options_.overrides.find(name);
    return found == options_.overrides.end() ? nullptr : &found->second;
}

void Sandbox::print(std::string_view text) {
    printed_ += text.size();
    if (printed_ > max_printed)
        throw Error("print(...) may say no more than 1 MiB");
    channel_.send(ScriptMessage::print, text);
}

// The families, and the functions that Scree adds to Lua's.
std::vector<std::string> Sandbox::scree_names() const {
    std::vector<std::string> names = families();
    names.insert(names.end(), {"object", "scene", "arg", "include", "srgb", "mm", "cm", "deg"});
    return names;
}

void Sandbox::check_overrides(const std::string& path) const {
    const std::vector<std::string> known(asked_.begin(), asked_.end());
    std::vector<Diagnostic> unused;
    for (const auto& [name, value] : options_.overrides) {
        if (asked_.contains(name))
            continue;
        std::string hint = did_you_mean(name, known);
        if (hint.empty() && !known.empty())
            hint = fmt::format("it asks for: {}", fmt::join(known, ", "));
        unused.push_back(
            {{path, 0}, "--set " + name, "the script asks for no arg(\"" + name + "\")", hint});
    }
    if (!unused.empty())
        throw Error(Fault::input, std::move(unused));
}

std::string Sandbox::describe(const std::string& path) {
    lua_atpanic(state_,
                [](lua_State*) -> int { end_at_limit(ScriptMessage::memory, watch.place); });
    luaL_requiref(state_, "_G", luaopen_base, 1);
    luaL_requiref(state_, LUA_STRLIBNAME, luaopen_string, 1);
    luaL_requiref(state_, LUA_TABLIBNAME, luaopen_table, 1);
    luaL_requiref(state_, LUA_MATHLIBNAME, luaopen_math, 1);
    luaL_requiref(state_, LUA_UTF8LIBNAME, luaopen_utf8, 1);
    luaL_requiref(state_, LUA_COLIBNAME, luaopen_coroutine, 1);
    lua_settop(state_, 0);
    add_scene_functions(state_);
    if (luaL_loadbufferx(state_, prelude_source.data(), prelude_source.size(), "=scree", "t") !=
            LUA_OK ||
        lua_pcall(state_, 0, 0, 0) != LUA_OK)
        throw std::logic_error(luaL_tolstring(state_, -1, nullptr));

    load(state_, path);
    open_files.push_back(path);
    includes[path] = {};
    lua_pushcfunction(state_, add_place);
    lua_insert(state_, 1);
    lua_sethook(state_, on_hook, LUA_MASKCOUNT | LUA_MASKCALL, instructions_between_checks);
    start_timer(options_.limits.seconds);
    const int status = lua_pcall(state_, 0, 1, 1);
    stop_timer();
    lua_sethook(state_, nullptr, 0, 0);
    if (status == LUA_ERRMEM)
        end_at_limit(ScriptMessage::memory, watch.place);
    if (status != LUA_OK) {
        LuaMessage message = parse_lua_message(luaL_tolstring(state_, -1, nullptr), {0, 0});
        if (message.hint.empty() && message.place.line > 0)
            message.hint = hidden_name_hint(sources_[std::size_t(message.place.file)],
                                            message.place.line, scree_names());
        throw Error(
            Diagnostic{location(message.place), {}, plain_words(message.text), message.hint});
    }
    check_overrides(path);
    return to_json(*describe_value(state_, *this, path), {.locations = true, .indent = false});
}

void Sandbox::run(const std::string& path) {
    confine_process(path, readable_folders(path));
    try {
        channel_.send(ScriptMessage::description, describe(path));
    } catch (const Error& error) {
        channel_.send(ScriptMessage::mistakes, mistakes_json(error.diagnostics()));
    } catch (const std::bad_alloc&) {
        end_at_limit(ScriptMessage::memory, watch.place);
    }
}

} // namespace scree
