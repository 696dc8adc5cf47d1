// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of the child: one Lua state that sees only what builds a description.
#pragma once

#include "scenes/reader/child_process.h"
#include "scenes/reader/script.h"
#include "scenes/reader/source_map.h"

#include <set>

struct lua_State;

namespace scree {

/// A line of one of the script's files; `file` is its index in order of reading, -1: not known.
struct Place {
    int file = -1;
    int line = 0;
};

/// Messages from the child to its parent.
struct ScriptMessage {
    static constexpr char file = 'f';        // name of the next file that is read
    static constexpr char print = 'p';       // what print(...) says
    static constexpr char description = 'd'; // JSON: the end
    static constexpr char mistakes = 'e';    // JSON list of diagnostics: the end
    static constexpr char time = 't';        // a Place: the time limit was crossed there
    static constexpr char memory = 'm';      // a Place: the memory limit was crossed there
};

/// Runs one script. Lives once per process, in a child made for it: a crossed limit ends the
/// process, so that no pcall of the script can catch it.
class Sandbox {
  public:
    Sandbox(const Channel& channel, const ScriptOptions& options);
    ~Sandbox();
    Sandbox(const Sandbox&) = delete;
    Sandbox& operator=(const Sandbox&) = delete;

    /// Runs the script and sends what it returned, or its mistakes.
    void run(const std::string& path);

    // What the functions that scripts call need:

    static Sandbox& of(lua_State* state);
    Place place(lua_State* state) const; // innermost line of a script that is being run
    Location location(Place place) const;
    Place place_of(const Location& where) const;
    static std::string prefix(Place place); // "#0:14: " before a message, "" for no place
    const std::string& file(int index) const { return files_[static_cast<std::size_t>(index)]; }
    const SourceMap& source_map(int file);

    /// Pushes the compiled script; throws Error when it cannot be read or is not Lua.
    void load(lua_State* state, const std::string& path);

    const std::vector<std::string>& families() const { return options_.families; }

    /// The value of --set for `name`, or null. Remembers that the script asked.
    const std::string* override_of(const std::string& name);

    void print(std::string_view text);

    struct Include {
        int value = 0; // reference in Lua's registry
        bool open = true;
    };
    std::map<std::string, Include> includes; // by path
    std::vector<std::string> open_files;     // being run, outermost first

  private:
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

/// Replaces what could reach the system or differ from run to run; called with the globals and the
/// scene functions in place (prelude.cpp).
extern const std::string_view prelude_source;

/// The value on the stack's top as nodes (lua_value.cpp). Throws Error with every value that is
/// none: functions, cycles, gaps in lists.
DescriptionNode describe_value(lua_State* state, Sandbox& sandbox, const std::string& path);

/// What a constructor's table is tagged with, or null for a plain table (constructors.cpp).
struct Tag {
    std::string kind;
    Place place;
};
bool read_tag(lua_State* state, int index, Tag& tag);

/// Splits "#0:14: message\n  hint" as Lua code throws it; `fallback` when it has no place.
struct LuaMessage {
    Place place;
    std::string text;
    std::string hint;
};
LuaMessage parse_lua_message(std::string message, Place fallback);

/// Lua's own messages in the words of this program (lua_message.cpp).
std::string plain_words(const std::string& message);

} // namespace scree
