// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <memory>
#include <span>

namespace scree {

/// Where a procedural is asked.
struct ShadingPoint {
    Vec3 position;       // in the object's own frame [m]
    float footprint = 0; // width of the pixel's filter at the point, in the object's frame [m]
    Vec2f uv;
    float uv_footprint = 0; // the footprint in UV; 0 where the mesh has none
};

/// What it answers.
struct ShadingSample {
    Color color{0.0F, 0.0F, 0.0F};
    float height = 0; // bump height [m]
};

/// A solid or surface texture evaluated at shading time, in batches; thread-safe once made.
class Procedural {
  public:
    virtual ~Procedural() = default;
    /// `points` and `samples` have the same length; every sample is written.
    virtual void evaluate(std::span<const ShadingPoint> points,
                          std::span<ShadingSample> samples) const = 0;
};

/// A colour that is constant or comes from a procedural.
struct Texture {
    Color constant{0.0F, 0.0F, 0.0F};
    std::shared_ptr<const Procedural> procedural; // null: constant
};

} // namespace scree
