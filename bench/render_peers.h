// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

namespace scree::bench {

/// `render_bench --peers ARGUMENTS`: prints how long Scree and other renderers take for pictures of
/// equal error. Returns the exit code.
int render_peers(std::span<const std::string> arguments);

} // namespace scree::bench
