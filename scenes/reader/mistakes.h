// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "core/text.h"

#include <algorithm>
#include <tuple>

namespace scree {

/// Collects the errors of a scene, so that a user sees all of them at once.
class Mistakes {
  public:
    void add(Location where, std::string path, std::string message, std::string hint = {}) {
        diagnostics_.push_back(
            {std::move(where), std::move(path), std::move(message), std::move(hint)});
    }

    void add(const Error& error) {
        diagnostics_.insert(diagnostics_.end(), error.diagnostics().begin(),
                            error.diagnostics().end());
    }

    /// Counts another use of an object that could not be made, whose errors are reported already.
    void add_repeated() { ++repeated_; }

    /// Increases with every error: unchanged after a check means that the check found none.
    std::size_t count() const { return diagnostics_.size() + repeated_; }

    /// Of what users should know although it is no mistake.
    const std::shared_ptr<Warnings>& warnings() const { return warnings_; }

    /// Throws the collected errors, if any, sorted by file and line and without duplicates. Those
    /// beyond `most` are only counted.
    void throw_if_any(std::size_t most = 50) {
        if (diagnostics_.empty())
            return;
        const auto key = [](const Diagnostic& d) {
            return std::tie(d.where.file, d.where.line, d.path, d.message);
        };
        std::stable_sort(diagnostics_.begin(), diagnostics_.end(),
                         [&](const auto& a, const auto& b) { return key(a) < key(b); });
        diagnostics_.erase(
            std::unique(diagnostics_.begin(), diagnostics_.end(),
                        [&](const auto& a, const auto& b) { return key(a) == key(b); }),
            diagnostics_.end());
        if (diagnostics_.size() > most) {
            const std::size_t more = diagnostics_.size() - most;
            diagnostics_.resize(most);
            diagnostics_.push_back({{diagnostics_.back().where.file, 0},
                                    {},
                                    "and " + counted(more, "more mistake"),
                                    {}});
        }
        throw Error(Fault::input, std::move(diagnostics_));
    }

  private:
    std::vector<Diagnostic> diagnostics_;
    std::size_t repeated_ = 0;
    std::shared_ptr<Warnings> warnings_ = std::make_shared<Warnings>();
};

} // namespace scree
