// SPDX-License-Identifier: GPL-3.0-or-later
// The text format of a script's sampled function: "columns rows", then the values row by row, each
// row from -x to +x, the rows from -z to +z.
#pragma once

#include "shapes/field/grid_field.h"

#include <string_view>

namespace scree {

/// Parses such a text, which the scene reader writes and a JSON scene contains. `most` is the
/// maximum number of columns and of rows. Throws Error for an invalid text.
SampleGrid parse_samples(std::string_view text, int most);

} // namespace scree
