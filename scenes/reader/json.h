// SPDX-License-Identifier: GPL-3.0-or-later
// A description as JSON. Tables are objects and lists are arrays; names that begin with $ are ours:
//   $kind  "mesh.box" of a constructor      $id, $ref  one node in several places
//   $files, $file, $line, $lines            where it was written, when not in this JSON file
//   $value a list or plain value that needs one of these; $number "nan", "inf" or "-inf"
#pragma once

#include "scenes/reader/description.h"

#include <string_view>

namespace scree {

/// Reads what to_json wrote, or JSON written by hand, whose values get their own lines in `file`.
/// Throws Error naming file and line.
DescriptionNode description_from_json(std::string_view text, const std::string& file);

} // namespace scree
