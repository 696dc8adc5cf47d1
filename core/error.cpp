// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"

#include <algorithm>
#include <cassert>
#include <numeric>

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

namespace {

// Damerau-Levenshtein distance (optimal string alignment): a swap of adjacent letters counts as
// one.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> above(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(above.begin(), above.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(above);
        above.swap(row);
    }
    return above[b.size()];
}

} // namespace

std::string nearest_name(std::string_view given, std::span<const std::string> known) {
    std::string best;
    std::size_t best_distance = given.size() / 3 + 2;
    for (const std::string& name : known) {
        const std::size_t distance = edit_distance(given, name);
        if (distance < best_distance && distance < std::max<std::size_t>(name.size(), 2)) {
            best_distance = distance;
            best = name;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view given, std::span<const std::string> known) {
    const std::string name = nearest_name(given, known);
    return name.empty() ? std::string{} : "did you mean " + name + "?";
}

} // namespace scree
