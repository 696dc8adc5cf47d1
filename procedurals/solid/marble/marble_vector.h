// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/procedural.h"
#include "procedurals/solid/marble/marble_as_cpp.h"

#include <span>

namespace scree {

/// Evaluates marble at several points, one in each lane of a vector, bit-identical to `marble_at`.
/// Returns false when it cannot: for unfiltered points, and for lattices that are not periodic,
/// have float nodes or do not store all their unique levels.
bool marble_in_lanes(const solid::Field& field, const solid::Marble& marble,
                     std::span<const ShadingPoint> points, std::span<ShadingSample> samples);

} // namespace scree
