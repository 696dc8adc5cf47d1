// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// Whether the text is meant as a baked file rather than as a scene: it has the key `aggregates`.
bool is_bake_json(std::string_view text);

/// The aggregates of a baked file (docs/formats.md). Regions and domains have rings only, no
/// triangles, and prototypes no mesh. Throws Error (input) that names the file and the key: not
/// JSON, keys missing or of another kind, numbers out of range, indices beyond the prototypes.
std::vector<Aggregate> read_bake_json(const std::string& text, const std::string& path);

} // namespace scree
