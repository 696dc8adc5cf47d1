// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the messages about values, in one voice.
#pragma once

#include "core/params.h"
#include "scenes/reader/description.h"

#include <string>
#include <vector>

namespace scree {

std::string in_words(double number, const std::string& unit = {}); // "25 m"

/// What a user gave: `25 m`, `the text "big"`, `a list of 2`, `mesh.box`, `nothing`.
std::string in_words(const Description& given, const std::string& unit = {});

std::string one_of(const std::vector<std::string>& names); // "naive, fill_gap or saturated"

/// "0.0001 to 1 m", "at least 0", "more than 0 and at most 1 m".
std::string limits_in_words(const ParamSpec& spec);

/// What the declaration asks for: "a number", "{low, high}", "a mesh.*".
std::string type_in_words(const ParamSpec& spec);

} // namespace scree
