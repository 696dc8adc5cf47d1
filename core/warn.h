// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace scree {

/// Takes what a user should know of a file although it is no error, such as parts that are not
/// read. Readers are given one and call it for each; it must not be empty.
using Warn = std::function<void(const std::string& message)>;

/// For callers that have nobody to tell.
inline void no_warning(const std::string& /*message*/) {}

} // namespace scree
