// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/range.h"
#include "generators/fibres/fibre_flow.h"
#include "generators/fibres/rotation.h"

#include <cstdint>
#include <optional>
#include <span>

namespace scree::fibres {

/// How fibres are shaped: chains of equal segments (Sakurai 2013, 5.2.1).
struct FibreShape {
    std::uint32_t segments = 32;
    Range length{1, 1};   // [m]
    double radius = 0.01; // at the root [m]
    double taper = 1;     // radius of the tip over that of the root
    Range theta{};        // of the turns about the carried z axis [rad]
    Range phi{};          // about the carried y axis, which lies along the segment [rad]

    std::uint32_t vertices() const { return segments + 1; }
    float radius_at(std::uint32_t vertex) const {
        return static_cast<float>(radius * (1 + (taper - 1) * vertex / segments));
    }
};

/// Where and how one fibre begins.
struct FibreStart {
    Vec3 position{0.0F};
    Rotation frame{}; // of the first segment: y lies along it
};

/// Length of the fibre's segments [m]; the stream's first number.
float draw_segment_length(const FibreShape& shape, Random& random);

/// Grows a fibre: writes its vertices [m] and the frames of its segments. Each next segment turns
/// by theta about z, then by phi about y, in the carried frame, each uniform in its range; with a
/// flow it then turns towards that.
void grow(const FibreShape& shape, const std::optional<FibreFlow>& flow, const FibreStart& start,
          float segment_length, Random& random, std::span<Vec3> points, std::span<Rotation> frames);

} // namespace scree::fibres
