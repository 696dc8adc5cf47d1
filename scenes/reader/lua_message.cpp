// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/sandbox.h"

#include <array>
#include <cstdio>
#include <regex>

namespace scree {

LuaMessage parse_lua_message(std::string message, Place fallback) {
    LuaMessage out{fallback, std::move(message), {}};
    // Every coroutine prepends its location; the innermost one is used.
    int file = 0;
    int line = 0;
    int length = 0;
    while (std::sscanf(out.text.c_str(), "#%d:%d: %n", &file, &line, &length) == 2 && length > 0) {
        out.place = {file, line};
        out.text.erase(0, static_cast<std::size_t>(length));
        length = 0;
    }
    if (const std::size_t hint = out.text.find("\n  "); hint != std::string::npos) {
        out.hint = out.text.substr(hint + 3);
        out.text.erase(hint);
    }
    return out;
}

std::string plain_words(const std::string& message) {
    struct Rule {
        const char* pattern;
        const char* words;
    };
    // Lua appends the variable that holds the value, if known: "(local 'x')", "(field 'x')", ...
    static constexpr std::array rules{
        Rule{R"(^attempt to call a (\w+) value \(\w+ '(.*)'\)$)", "$2 is a $1, not a function"},
        Rule{R"(^attempt to call a (\w+) value$)", "a $1 cannot be called"},
        Rule{R"(^attempt to index a (\w+) value \(\w+ '(.*)'\)$)", "$2 is a $1 and has no fields"},
        Rule{R"(^attempt to index a (\w+) value$)", "a $1 has no fields"},
        Rule{R"(^attempt to perform arithmetic on a (\w+) value \(\w+ '(.*)'\)$)",
             "$2 is a $1; arithmetic needs numbers"},
        Rule{R"(^attempt to perform arithmetic on a (\w+) value$)",
             "arithmetic needs numbers, not a $1"},
        Rule{R"(^attempt to concatenate a (\w+) value \(\w+ '(.*)'\)$)",
             "$2 is a $1; .. joins texts and numbers only"},
        Rule{R"(^attempt to concatenate a (\w+) value$)",
             ".. joins texts and numbers only, not a $1"},
        Rule{R"(^attempt to compare two (\w+) values$)", "two values of type $1 have no order"},
        Rule{R"(^attempt to compare (\w+) with (\w+)$)", "$1 and $2 cannot be compared"},
        Rule{R"(^attempt to get length of a (\w+) value \(\w+ '(.*)'\)$)",
             "$2 is a $1 and has no length"},
        Rule{R"(^(.*)stack overflow[^]*$)",
             "functions call each other too deeply; is there a recursion that never ends?"},
        Rule{R"(^error in error handling$)",
             "functions call each other too deeply; is there a recursion that never ends?"},
        Rule{R"(^resulting string too large$)", "the text would be too long"},
        Rule{R"(^'(.+)' expected \(to close '(.+)' at line (\d+)\) near (.+)$)",
             "expected $1 to close the $2 of line $3, found $4"},
        Rule{R"(^'?(.+?)'? expected near (.+)$)", "expected $1 before $2"},
        Rule{R"(^unexpected symbol near (.+)$)", "$1 cannot stand here"},
        Rule{R"(^unfinished string near (.+)$)", "this text has no closing quote: $1"},
        Rule{R"(^attempt to load a binary chunk[^]*$)",
             "this is compiled Lua; scripts must be text"},
    };
    std::string words = message;
    for (const Rule& rule : rules) {
        const std::regex pattern(rule.pattern);
        if (words.size() < 1000 && std::regex_match(words, pattern)) {
            words = std::regex_replace(words, pattern, rule.words);
            if (const std::size_t nil = words.find("a nil"); nil != std::string::npos)
                words.erase(nil, 2);
            break;
        }
    }
    if (const std::size_t at = words.find("<eof>"); at != std::string::npos)
        words.replace(at, 5, "the end of the file");
    return words;
}

} // namespace scree
