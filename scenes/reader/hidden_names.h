// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace scree {

/// For a mistake on `line` of a script: when that line uses one of Scree's `names`, such as
/// light.area { ... }, which the script gave another value above it, as by `local light = ...`:
/// which line did so. Empty otherwise.
std::string hidden_name_hint(std::string_view source, int line, std::span<const std::string> names);

} // namespace scree
