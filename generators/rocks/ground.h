// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/top_grid.h"

#include <limits>
#include <optional>

namespace scree::rocks {

/// What rocks lie on: a plane that may slope up towards -z, or a mesh seen from above.
class Ground {
  public:
    /// @param slope of the plane [rad]
    explicit Ground(double slope) : rise_(std::tan(slope)) {}
    explicit Ground(const Mesh& mesh);

    /// The height at a place; the lowest float where a mesh does not reach [m].
    double height(const Vec2& place) const;

    bool is_under(const Vec2& place) const {
        return height(place) > std::numeric_limits<float>::lowest();
    }

    /// Of a plane: its height falls by this much for a metre along +z.
    double rise() const { return rise_; }

    /// The mesh's upper triangles; null for a plane.
    const TopGrid* mesh() const { return mesh_ ? &*mesh_ : nullptr; }

  private:
    double rise_ = 0;
    std::optional<TopGrid> mesh_;
};

} // namespace scree::rocks
