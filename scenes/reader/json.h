// SPDX-License-Identifier: GPL-3.0-or-later
// A description as JSON. Tables are objects and lists are arrays. Names that begin with $ have a
// special meaning:
//   $kind                          kind of a constructor's table: "mesh.box"
//   $id, $ref                      a node that occurs in several places
//   $files, $file, $line, $lines   location, unless it is that in the JSON file
//   $value                         the list or plain value of an object with the names above
//   $number                        "nan", "inf" or "-inf"
#pragma once

#include "scenes/reader/description.h"

#include <string_view>

namespace scree {

/// Reads the output of to_json, or JSON written by hand, whose values are located at their lines in
/// `file`. Throws Error naming file and line.
DescriptionNode description_from_json(std::string_view text, const std::string& file);

} // namespace scree
