// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// A token of Lua 5.4, except that a keyword after a dot is a name. `text` is the name, the symbol,
/// or the text between a string's quotes.
struct LuaToken {
    enum class Type { name, keyword, number, string, symbol };
    Type type = Type::symbol;
    std::string_view text;
    int line = 1; // where it begins

    bool is(std::string_view symbol_or_keyword) const {
        return (type == Type::symbol || type == Type::keyword) && text == symbol_or_keyword;
    }
};

/// Splits a script into tokens that point into `source`, without comments. Invalid Lua gives
/// arbitrary tokens, never an error: errors are reported by Lua's compiler.
std::vector<LuaToken> lex_lua(std::string_view source);

} // namespace scree
