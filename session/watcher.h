// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace scree {

/// Receives the messages and the progress of a session: a terminal or the studio. Called from one
/// thread at a time.
class Watcher {
  public:
    virtual ~Watcher() = default;

    /// A permanent line.
    virtual void say(const std::string& line) = 0;

    /// A line about something that is no error.
    virtual void warn(const std::string& text) { say("warning: " + text); }

    /// The fraction of `what` that is done, in [0, 1], with a detail to show. May be called often.
    virtual void progress(const std::string& what, double fraction, const std::string& detail) = 0;
};

/// Ignores everything.
class NoWatcher final : public Watcher {
  public:
    void say(const std::string& /*line*/) override {}
    void progress(const std::string& /*what*/, double /*fraction*/,
                  const std::string& /*detail*/) override {}
};

} // namespace scree
