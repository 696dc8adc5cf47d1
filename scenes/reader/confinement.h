// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace scree {

/// Takes from this process, for good, what a scene script has no use for: all files but the script
/// and those below the folders, which it can only read (Landlock), and all calls of the system but
/// those that computing, reading files and answering take (seccomp). It is a second wall: the
/// script's language has no such functions. Where the kernel has neither, nothing happens.
void confine_process(const std::string& script, const std::vector<std::string>& folders) noexcept;

} // namespace scree
