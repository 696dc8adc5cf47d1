// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <memory>
#include <span>

namespace scree {

/// Where a procedural is evaluated.
struct ShadingPoint {
    Vec3 position;       // in the object's own frame [m]
    float footprint = 0; // width of the pixel's filter across the line of sight, in that frame [m]
    Vec2f uv{0.0F, 0.0F};
    float uv_footprint = 0; // the footprint in UV; 0 where the mesh has none
    float random = 0;       // of the instance, in [0, 1)
    // The filter projected onto the surface: two perpendicular vectors, each as long as the filter
    // is wide in that direction; 0 for a point. They are widths of box filters: variance length^2
    // / 12.
    Vec3 across{0.0F, 0.0F, 0.0F}; // the shorter one: as long as `footprint`
    Vec3 along{0.0F, 0.0F, 0.0F};  // the longer one: stretched where the surface is seen at a slant
};

/// A procedural's answer at one point.
struct ShadingSample {
    static constexpr float unset = -1;

    Color color{0.0F, 0.0F, 0.0F};
    float height = 0;             // bump height [m]
    Vec3 slope{0.0F, 0.0F, 0.0F}; // its gradient in the object's frame
    float roughness = unset;      // perceptual, in [0, 1]; unset: the material's own
    float value = 0;              // what drives the colour, in [0, 1]: a mask, a density
};

class Device;

/// A solid or surface texture evaluated at shading time, in batches; thread-safe once made.
class Procedural {
  public:
    virtual ~Procedural() = default;
    /// `points` and `samples` have the same length; every sample is written.
    virtual void evaluate(std::span<const ShadingPoint> points,
                          std::span<ShadingSample> samples) const = 0;

    /// The same for as many points as there are, on all threads, or on `device` where there is one
    /// and the procedural has a kernel; the two agree within 1e-4. Throws Error (resource) when the
    /// device fails.
    virtual void bake(std::span<const ShadingPoint> points, std::span<ShadingSample> samples,
                      Device* device) const;

    /// Whether it depends on the position alone, so that it fills space: slices and volumes.
    virtual bool solid() const { return false; }
};

class Params;

/// Makes a procedural from its checked parameters.
using MakeProcedural = std::shared_ptr<const Procedural>(const Params& params);

} // namespace scree
