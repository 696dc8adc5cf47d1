// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/fibres/adjustment.h"
#include "generators/fibres/fibres_settings.h"
#include "generators/fibres/placement.h"

namespace scree::fibres {

/// Grows each fibre by its index alone, from random streams of its own, where it is first placed.
class FibreSource {
  public:
    /// Either in `interior` or on `roots`; what is given must outlive this.
    FibreSource(const FibresSettings& settings, const Interior* interior, const Roots* roots)
        : settings_(&settings), interior_(interior), roots_(roots) {}

    /// Writes the fibre's vertices [m] and the frames of its segments.
    void grow(std::size_t fibre, std::span<Vec3> points, std::span<Rotation> frames) const;

    /// Of the fibre's segments [m].
    float segment_length(std::size_t fibre) const;

    /// All fibres, and for each the x axis of its first segment's frame.
    struct Placed {
        RigidFibres rigid;
        std::vector<Vec3> normals;
    };
    Placed place_all() const;

  private:
    const FibresSettings* settings_;
    const Interior* interior_;
    const Roots* roots_;
};

} // namespace scree::fibres
