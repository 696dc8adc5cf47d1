// SPDX-License-Identifier: GPL-3.0-or-later
// Error messages for users: file, line, parameter, the value given and what is allowed.
#pragma once

#include "core/nearest_name.h"

#include <exception>
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

/// The kind of a failure; the value is the program's exit code.
enum class Fault { input = 1, usage = 2, resource = 3 };

/// One error: "where: path: message", then the hint on an indented line.
struct Diagnostic {
    Location where;
    std::string path; // "generator.layout.components[2].margin"; may be empty
    std::string message;
    std::string hint; // "did you mean radius?"; may be empty

    std::string text() const;
};

/// The only exception type for errors that users see; caught in app. Holds at least one diagnostic.
class Error : public std::exception {
  public:
    Error(Fault fault, std::vector<Diagnostic> diagnostics);
    explicit Error(Diagnostic diagnostic);
    explicit Error(std::string message);

    static Error usage(std::string message, std::string hint = {});
    static Error resource(std::string message);

    /// The same error, with `where` and `path` set in diagnostics that have none.
    Error located(const Location& where, const std::string& path) const;

    Fault fault() const noexcept { return fault_; }
    const std::vector<Diagnostic>& diagnostics() const noexcept { return diagnostics_; }
    const char* what() const noexcept override { return text_.c_str(); }

  private:
    Fault fault_;
    std::vector<Diagnostic> diagnostics_;
    std::string text_; // all diagnostics, one under the other
};

} // namespace scree
