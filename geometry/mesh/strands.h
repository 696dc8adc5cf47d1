// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scree {

/// Polylines with a radius at every point: hairs, fibres, stems. Strand i has the points from
/// offsets[i] to before offsets[i + 1], at least two. Plain data.
struct Strands {
    std::string name;                   // as shown to users
    std::vector<Vec3> points;           // of all strands, one strand after the other [m]
    std::vector<float> radii;           // one per point [m]
    std::vector<std::uint32_t> offsets; // one more than there are strands; the first is 0
    std::vector<float> randoms;         // one per strand, uniform in [0, 1)
    // One per strand, unit length: square to the first segment, carried along without twist it
    // gives every point a frame.
    std::vector<Vec3> normals;

    std::size_t count() const { return offsets.empty() ? 0 : offsets.size() - 1; }
};

} // namespace scree
