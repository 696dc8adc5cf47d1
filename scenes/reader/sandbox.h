// SPDX-License-Identifier: GPL-3.0-or-later
// The Lua state inside the child process, which can only build a description.
#pragma once

#include "scenes/reader/child_process.h"
#include "scenes/reader/script.h"
#include "scenes/reader/source_map.h"

#include <set>

struct lua_State;

namespace scree {

/// A line of one of the script's files; `file` is its index in order of reading, -1: unknown.
struct Place {
    int file = -1;
    int line = 0;
};

/// Messages from the child to its parent.
struct ScriptMessage {
    static constexpr char file = 'f';        // name of the next file that is read
    static constexpr char print = 'p';       // output of print(...)
    static constexpr char description = 'd'; // JSON; the last message
    static constexpr char mistakes = 'e';    // JSON list of diagnostics; the last message
    static constexpr char time = 't';        // Place where the time limit was exceeded
    static constexpr char memory = 'm';      // Place where the memory limit was exceeded
};

/// Runs one script. There is one sandbox per process, in a child made for it: exceeding a limit
/// ends the process, so that the script cannot catch it by pcall.
class Sandbox {
  public:
    Sandbox(const Channel& channel, const ScriptOptions& options);
    ~Sandbox();
    Sandbox(const Sandbox&) = delete;
    Sandbox& operator=(const Sandbox&) = delete;

    /// Runs the script and sends its result or its errors.
    void run(const std::string& path);

    // For the functions that scripts call:

    static Sandbox& of(lua_State* state);
    Place place(lua_State* state) const; // innermost running line of a script
    Location location(Place place) const;
    Place place_of(const Location& where) const;
    static std::string prefix(Place place); // "#0:14: " before a message, "" for no place
    const std::string& file(int index) const { return files_[static_cast<std::size_t>(index)]; }
    const SourceMap& source_map(int file);

    /// Throws Error unless it is called like a script and lies, behind links, in the folder of the
    /// scene, below it, or where ScriptOptions::readable_folders allow.
    void check_may_include(const std::string& path) const;

    /// Pushes the compiled script; throws Error when it cannot be read or is not valid Lua.
    void load(lua_State* state, const std::string& path);

    const std::vector<std::string>& families() const { return options_.families; }

    /// The value of --set for `name`, or null. Marks the override as used.
    const std::string* override_of(const std::string& name);

    void print(std::string_view text);

    struct Include {
        int value = 0; // reference in Lua's registry
        bool open = true;
    };
    std::map<std::string, Include> includes; // by path
    std::vector<std::string> open_files;     // those being run, outermost first

  private:
    std::vector<std::string> readable_folders(const std::string& scene) const;
    std::vector<std::string> scree_names() const;
    void check_overrides(const std::string& path) const;
    std::string describe(const std::string& path);

    const Channel& channel_;
    const ScriptOptions& options_;
    lua_State* state_ = nullptr;
    std::vector<std::string> files_;
    std::vector<std::string> sources_;
    std::map<int, SourceMap> source_maps_;
    std::set<std::string> asked_;
    std::size_t printed_ = 0;
};

/// Adds the functions of scene scripts to the globals (constructors.cpp).
void add_scene_functions(lua_State* state);

/// Lua code that removes access to the system and replaces non-deterministic functions. Run after
/// the globals and the scene functions are set (prelude.cpp).
extern const std::string_view prelude_source;

/// The value on top of the stack as nodes (lua_value.cpp). Throws Error for everything that is not
/// data: functions, cycles, lists with gaps.
DescriptionNode describe_value(lua_State* state, Sandbox& sandbox, const std::string& path);

/// The tag of a constructor's table (constructors.cpp).
struct Tag {
    std::string kind;
    Place place;
};
bool read_tag(lua_State* state, int index, Tag& tag);

/// The parts of a Lua error "#0:14: message\n  hint"; `fallback` is used when it has no place.
struct LuaMessage {
    Place place;
    std::string text;
    std::string hint;
};
LuaMessage parse_lua_message(std::string message, Place fallback);

/// Rewrites Lua's own messages in plainer language (lua_message.cpp).
std::string plain_words(const std::string& message);

} // namespace scree
