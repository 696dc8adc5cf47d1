// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/lua_lexer.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace scree {

namespace {

constexpr std::array keywords{"and",   "break", "do",       "else", "elseif", "end",
                              "false", "for",   "function", "goto", "if",     "in",
                              "local", "nil",   "not",      "or",   "repeat", "return",
                              "then",  "true",  "until",    "while"};
constexpr std::array long_symbols{"...", "==", "~=", "<=", ">=", "//", "::", "<<", ">>", ".."};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

class Lexer {
  public:
    explicit Lexer(std::string_view source) : source_(source) {
        if (peek() == '#') // Lua skips a first line that begins with #
            skip_line();
    }

    std::vector<LuaToken> run() {
        std::vector<LuaToken> tokens;
        while (at_ < source_.size()) {
            const char c = peek();
            if (c == '\n' || std::isspace(static_cast<unsigned char>(c)) != 0)
                step();
            else if (c == '-' && peek(1) == '-')
                skip_comment();
            else
                add(tokens, token());
        }
        return tokens;
    }

  private:
    using Type = LuaToken::Type;

    // A keyword after a dot is treated as a name (field.function).
    static void add(std::vector<LuaToken>& tokens, LuaToken token) {
        if (token.type == Type::keyword && !tokens.empty() && tokens.back().is("."))
            token.type = Type::name;
        tokens.push_back(token);
    }

    char peek(std::size_t ahead = 0) const {
        return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
    }

    void step() {
        if (peek() == '\n')
            ++line_;
        ++at_;
    }

    void skip_line() {
        while (at_ < source_.size() && peek() != '\n')
            ++at_;
    }

    void skip_comment() {
        at_ += 2;
        if (long_bracket_level() < 0)
            skip_line();
        else
            long_bracket();
    }

    // 0 for [[, 1 for [=[, ...; -1 when no long bracket opens here
    int long_bracket_level() const {
        if (peek() != '[')
            return -1;
        std::size_t equals = 0;
        while (peek(1 + equals) == '=')
            ++equals;
        return peek(1 + equals) == '[' ? static_cast<int>(equals) : -1;
    }

    std::string_view long_bracket() {
        const auto level = static_cast<std::size_t>(long_bracket_level());
        at_ += level + 2;
        const std::size_t begin = at_;
        const std::string closing = "]" + std::string(level, '=') + "]";
        const std::size_t end = std::min(source_.find(closing, begin), source_.size());
        while (at_ < end)
            step();
        at_ = std::min(end + closing.size(), source_.size());
        return source_.substr(begin, end - begin);
    }

    std::string_view quoted() {
        const char quote = peek();
        step();
        const std::size_t begin = at_;
        while (at_ < source_.size() && peek() != quote) {
            if (peek() == '\\')
                step();
            step();
        }
        at_ = std::min(at_, source_.size());
        const std::string_view inside = source_.substr(begin, at_ - begin);
        step();
        return inside;
    }

    LuaToken token() {
        const std::size_t begin = at_;
        const int line = line_;
        const char c = peek();
        if (is_letter(c)) {
            while (is_letter(peek()) || is_digit(peek()))
                ++at_;
            const std::string_view text = source_.substr(begin, at_ - begin);
            const bool keyword =
                std::find(keywords.begin(), keywords.end(), text) != keywords.end();
            return {keyword ? Type::keyword : Type::name, text, line};
        }
        if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
            while (is_letter(peek()) || is_digit(peek()) || peek() == '.' ||
                   ((peek() == '-' || peek() == '+') && is_exponent(source_[at_ - 1])))
                ++at_;
            return {Type::number, source_.substr(begin, at_ - begin), line};
        }
        if (c == '"' || c == '\'')
            return {Type::string, quoted(), line};
        if (long_bracket_level() >= 0)
            return {Type::string, long_bracket(), line};
        for (const std::string_view symbol : long_symbols)
            if (source_.substr(at_).starts_with(symbol)) {
                at_ += symbol.size();
                return {Type::symbol, source_.substr(begin, symbol.size()), line};
            }
        ++at_;
        return {Type::symbol, source_.substr(begin, 1), line};
    }

    static bool is_exponent(char c) { return c == 'e' || c == 'E' || c == 'p' || c == 'P'; }

    std::string_view source_;
    std::size_t at_ = 0;
    int line_ = 1;
};

} // namespace

std::vector<LuaToken> lex_lua(std::string_view source) { return Lexer(source).run(); }

} // namespace scree
