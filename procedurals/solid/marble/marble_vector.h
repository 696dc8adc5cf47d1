// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/procedural.h"
#include "procedurals/solid/marble/marble_as_cpp.h"

#include <span>

namespace scree {

/// Evaluates marble at several points, one in each lane of a vector, to the bits of `marble_at`.
/// Answers false, and does nothing, where it cannot: for points without filters, and for lattices
/// that do not repeat, store floats or draw levels on demand.
bool marble_in_lanes(const solid::Field& field, const solid::Marble& marble,
                     std::span<const ShadingPoint> points, std::span<ShadingSample> samples);

} // namespace scree
