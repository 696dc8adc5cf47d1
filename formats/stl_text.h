// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/file_mesh.h"

#include <string_view>

namespace scree {

/// Whether the bytes are text: without the control characters that every binary file has among its
/// numbers, and ASCII unless they begin with a keyword.
bool is_stl_text(std::string_view bytes);

/// Appends the facets of all solids of a text file. Facets of more than three corners are
/// triangulated. Throws Error (input) that names the line of what is not expected.
void read_stl_text(std::string_view bytes, FileMesh& mesh);

} // namespace scree
