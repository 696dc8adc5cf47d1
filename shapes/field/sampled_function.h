// SPDX-License-Identifier: GPL-3.0-or-later
// The text that a script's function becomes: "columns rows" and the values row by row, each row
// from -x to +x, the rows from -z to +z.
#pragma once

#include "shapes/field/grid_field.h"

#include <string_view>

namespace scree {

/// The samples of `text`, which the scene reader wrote or a JSON scene holds. Throws Error when it
/// is no such text; `most` is the largest number of columns or rows.
SampleGrid parse_samples(std::string_view text, int most);

} // namespace scree
