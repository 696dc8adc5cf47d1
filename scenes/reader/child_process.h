// SPDX-License-Identifier: GPL-3.0-or-later
// A forked child process with resource limits, which sends messages to its parent through a pipe.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace scree {

/// The child's end of the pipe. A message has a type, one letter, and bytes.
class Channel {
  public:
    explicit Channel(int descriptor) : descriptor_(descriptor) {}

    /// Async-signal-safe.
    void send(char type, std::string_view bytes) const noexcept;

  private:
    int descriptor_;
};

/// Limits enforced by the operating system, in case the finer limits inside the child fail.
struct ChildLimits {
    double cpu_seconds = 20;
    double wall_seconds = 60;
    std::size_t memory = std::size_t{1} << 30; // in addition to the parent's mappings [bytes]
};

/// How the child ended.
enum class ChildEnd { done, time, crashed };

/// Runs `body` in a forked child that cannot write files or start processes, and passes every
/// message to `receive`. The child ends when `body` returns. Throws Error (resource) when no child
/// can be started.
ChildEnd run_in_child(const ChildLimits& limits, const std::function<void(const Channel&)>& body,
                      const std::function<void(char type, std::string bytes)>& receive);

} // namespace scree
