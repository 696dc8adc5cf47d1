// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"

#include <cassert>

namespace scree {

std::string Location::text() const { return line > 0 ? file + ":" + std::to_string(line) : file; }

std::string Diagnostic::text() const {
    std::string out = where.text();
    if (!out.empty())
        out += ": ";
    if (!path.empty())
        out += path + ": ";
    out += message;
    if (!hint.empty())
        out += "\n  " + hint;
    return out;
}

Error::Error(Fault fault, std::vector<Diagnostic> diagnostics)
    : fault_(fault), diagnostics_(std::move(diagnostics)) {
    assert(!diagnostics_.empty());
    for (const Diagnostic& d : diagnostics_) {
        if (!text_.empty())
            text_ += '\n';
        text_ += d.text();
    }
}

Error::Error(Diagnostic diagnostic)
    : Error(Fault::input, std::vector<Diagnostic>{std::move(diagnostic)}) {}

Error::Error(std::string message) : Error(Diagnostic{{}, {}, std::move(message), {}}) {}

Error Error::usage(std::string message, std::string hint) {
    return {Fault::usage, {Diagnostic{{}, {}, std::move(message), std::move(hint)}}};
}

Error Error::resource(std::string message) {
    return {Fault::resource, {Diagnostic{{}, {}, std::move(message), {}}}};
}

Error Error::located(const Location& where, const std::string& path) const {
    std::vector<Diagnostic> placed = diagnostics_;
    for (Diagnostic& d : placed) {
        if (d.where.file.empty())
            d.where = where;
        if (d.path.empty())
            d.path = path;
    }
    return {fault_, std::move(placed)};
}

} // namespace scree
