// SPDX-License-Identifier: GPL-3.0-or-later
// Suggestions for names that are not known.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace scree {

/// The name in `known` that `given` most likely stands for, or "" when none is near. In this order:
/// the same letters in another case or with other separators; another word for the same thing, as
/// circle for disk; the only one that begins with it; the nearest by edit distance, of at most a
/// third of the letters.
std::string nearest_name(std::string_view given, std::span<const std::string> known);

/// "did you mean X?", or "" when no name is near.
std::string did_you_mean(std::string_view given, std::span<const std::string> known);

} // namespace scree
