// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/hidden_names.h"

#include "scenes/reader/lua_lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace scree {

namespace {

using Tokens = std::vector<LuaToken>;

// Whether the name at `i` begins a use as Scree's own: light.area, mesh[..], scene { .. }, mm(..).
bool is_use(const Tokens& tokens, std::size_t i) {
    if (i > 0 && (tokens[i - 1].is(".") || tokens[i - 1].is(":")))
        return false;
    if (i + 1 >= tokens.size())
        return false;
    const LuaToken& next = tokens[i + 1];
    return next.is(".") || next.is("[") || next.is("{") || next.is("(");
}

// The names after `local` or `for`, and the parameters after `function name`, begin at `i`.
bool declares(const Tokens& tokens, std::size_t i, std::string_view name) {
    if (tokens[i].is("function"))
        while (i < tokens.size() && !tokens[i].is("("))
            ++i;
    for (++i; i < tokens.size(); ++i) {
        if (tokens[i].type == LuaToken::Type::name && tokens[i].text == name)
            return true;
        if (tokens[i].is("function") && i + 1 < tokens.size() && tokens[i + 1].text == name)
            return true; // local function light()
        // Attributes such as <const> stand between names.
        if (tokens[i].type != LuaToken::Type::name && !tokens[i].is(",") && !tokens[i].is("<") &&
            !tokens[i].is(">"))
            return false;
    }
    return false;
}

// Whether the statement at `i` gives the name another value: light = ...
bool assigns(const Tokens& tokens, std::size_t i, std::string_view name) {
    const bool field = i > 0 && (tokens[i - 1].is(".") || tokens[i - 1].is(",") ||
                                 tokens[i - 1].is("{") || tokens[i - 1].is(";"));
    return !field && tokens[i].type == LuaToken::Type::name && tokens[i].text == name &&
           i + 1 < tokens.size() && tokens[i + 1].is("=");
}

} // namespace

std::string hidden_name_hint(std::string_view source, int line,
                             std::span<const std::string> names) {
    const Tokens tokens = lex_lua(source);
    for (const std::string& name : names) {
        int hidden = 0; // the last line above that does so
        bool used = false;
        for (std::size_t i = 0; i < tokens.size() && tokens[i].line <= line; ++i) {
            const bool opens =
                tokens[i].is("local") || tokens[i].is("for") || tokens[i].is("function");
            if ((opens && declares(tokens, i, name)) || assigns(tokens, i, name))
                hidden = tokens[i].line;
            used = used || (tokens[i].line == line && hidden > 0 && tokens[i].text == name &&
                            tokens[i].type == LuaToken::Type::name && is_use(tokens, i));
        }
        if (used)
            return fmt::format(
                "line {} gives the name {} to something else, which hides Scree's {}; "
                "choose another name there",
                hidden, name, name);
    }
    return {};
}

} // namespace scree
