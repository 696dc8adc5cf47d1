// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of numbers on the command line, which CLI11 reads too leniently: "nan" counts as positive,
// "-1" as a large number. Each returns what is wrong, in words, or "".
#pragma once

#include <string>

namespace scree {

/// Of a number above 0.
std::string problem_of_positive(const std::string& given);

/// Of a whole number of 64 bits.
std::string problem_of_seed(const std::string& given);

/// Of a number of pixels of a layout's longer side.
std::string problem_of_size(const std::string& given);

} // namespace scree
