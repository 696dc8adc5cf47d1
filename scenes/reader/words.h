// SPDX-License-Identifier: GPL-3.0-or-later
// Consistent wording of values, types and limits in error messages.
#pragma once

#include "core/params.h"
#include "scenes/reader/description.h"

#include <string>
#include <vector>

namespace scree {

std::string in_words(double number, const std::string& unit = {}); // "25 m"

/// A given value: `25 m`, `the text "big"`, `a list of 2`, `mesh.box`, `nothing`.
std::string in_words(const Description& given, const std::string& unit = {});

std::string one_of(const std::vector<std::string>& names); // "naive, fill_gap or saturated"

/// "0.0001 to 1 m", "at least 0", "more than 0 and at most 1 m".
std::string limits_in_words(const ParamSpec& spec);

/// The declared type: "a number", "{low, high}", "a mesh.*".
std::string type_in_words(const ParamSpec& spec);

/// A hint where a list of `count` numbers was written with the names by which it is described, as
/// {x = 1, z = 2}; empty otherwise.
std::string without_names(const Description& given, std::size_t count);

} // namespace scree
