// SPDX-License-Identifier: GPL-3.0-or-later
// What a user sees when something is wrong: file, line, the field, what was given, what is allowed.
#pragma once

#include <exception>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// Where a value was written. `line` is 1-based; 0 means the file as a whole.
struct Location {
    std::string file;
    int line = 0;

    std::string text() const; // "gravel.lua:14", "gravel.lua", or "" for an empty location
};

/// Whose fault it is; the value is the program's exit code.
enum class Fault { input = 1, usage = 2, resource = 3 };

/// One mistake: "where: path: message", with the hint on an indented line of its own.
struct Diagnostic {
    Location where;
    std::string path; // "generator.layout.components[2].margin"; may be empty
    std::string message;
    std::string hint; // "did you mean radius?"; may be empty

    std::string text() const;
};

/// The one exception type for users' mistakes; caught in app. Holds at least one diagnostic.
class Error : public std::exception {
  public:
    Error(Fault fault, std::vector<Diagnostic> diagnostics);
    explicit Error(Diagnostic diagnostic);
    explicit Error(std::string message);

    static Error usage(std::string message, std::string hint = {});
    static Error resource(std::string message);

    /// The same, its mistakes placed at `where` and `path` as far as they do not say their own.
    Error located(const Location& where, const std::string& path) const;

    Fault fault() const noexcept { return fault_; }
    const std::vector<Diagnostic>& diagnostics() const noexcept { return diagnostics_; }
    const char* what() const noexcept override { return text_.c_str(); }

  private:
    Fault fault_;
    std::vector<Diagnostic> diagnostics_;
    std::string text_; // all diagnostics, one under the other
};

/// The name in `known` nearest to `given` by edit distance, or "" when none is near enough to be
/// what the user meant (more than a third of the letters differ).
std::string nearest_name(std::string_view given, std::span<const std::string> known);

/// "did you mean X?", or "" when no name is near.
std::string did_you_mean(std::string_view given, std::span<const std::string> known);

} // namespace scree
