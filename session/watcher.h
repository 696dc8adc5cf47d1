// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace scree {

/// Who watches a session: a terminal, or the studio. Called from one thread at a time.
class Watcher {
  public:
    virtual ~Watcher() = default;

    /// A line that stays.
    virtual void say(const std::string& line) = 0;

    /// How far `what` is, in [0, 1]; `detail` stands beside it. Cheap to call often.
    virtual void progress(const std::string& what, double fraction, const std::string& detail) = 0;
};

/// For when nobody watches.
class NoWatcher final : public Watcher {
  public:
    void say(const std::string& /*line*/) override {}
    void progress(const std::string& /*what*/, double /*fraction*/,
                  const std::string& /*detail*/) override {}
};

} // namespace scree
