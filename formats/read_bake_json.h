// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// Whether a JSON text is a baked file rather than a scene: whether it has the key `aggregates`.
bool is_bake_json(std::string_view text);

/// Reads the aggregates of a baked file (docs/formats.md). Regions and domains have rings but no
/// triangles; prototypes have no mesh. A prototype of strands has those of all its instances, in
/// the world, and one instance where it stands. Throws Error (input) naming the file and the key
/// for invalid JSON, missing keys, wrong types, numbers out of range and invalid prototype indices.
std::vector<Aggregate> read_bake_json(const std::string& text, const std::string& path);

} // namespace scree
