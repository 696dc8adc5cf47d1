// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <memory>
#include <span>

namespace scree {

/// A point at which a procedural is evaluated.
struct ShadingPoint {
    Vec3 position;       // in the object's frame [m]; see Procedural::scales_with_object
    float footprint = 0; // width of the pixel filter perpendicular to the view ray, likewise [m]
    Vec2f uv{0.0F, 0.0F};
    float uv_footprint = 0; // the footprint in UV; 0 where the mesh has no UVs
    float random = 0;       // of the instance, in [0, 1)
    // The filter on the surface: a box filter with two perpendicular sides, whose variance along
    // each is length^2 / 12. Both are 0 for an unfiltered point.
    Vec3 across{0.0F, 0.0F, 0.0F}; // the short side, `footprint` long
    Vec3 along{0.0F, 0.0F, 0.0F};  // the long side, stretched by the slant of the surface
    // In the scene; of a texture over UVs, in the object's frame.
    float level = 0; // height over y = 0 [m]
    float up = 1;    // y of the surface's unit normal
};

/// The value of a procedural at a point.
struct ShadingSample {
    static constexpr float unset = -1;

    Color color{0.0F, 0.0F, 0.0F};
    float height = 0;             // bump height [m]
    Vec3 slope{0.0F, 0.0F, 0.0F}; // gradient of the height by the position
    float roughness = unset;      // perceptual, in [0, 1]; unset: that of the material
    float value = 0;              // the scalar behind the colour, in [0, 1]: a mask, a density
};

class Device;

/// A solid or surface texture, evaluated in batches at shading time. Immutable, so thread-safe.
class Procedural {
  public:
    virtual ~Procedural() = default;
    /// `points` and `samples` have the same length; every sample is written.
    virtual void evaluate(std::span<const ShadingPoint> points,
                          std::span<ShadingSample> samples) const = 0;

    /// Evaluates many points, on `device` if it is not null and the procedural has a kernel,
    /// otherwise on all threads; the results agree within 1e-4. Throws Error (resource) when the
    /// device fails.
    virtual void bake(std::span<const ShadingPoint> points, std::span<ShadingSample> samples,
                      Device* device) const;

    /// Whether the texture grows and shrinks with its object: positions, slopes and heights are in
    /// the object's own units. Otherwise they are metres of the world, in the object's frame, so
    /// that the grain is as fine on a small copy as on a large one.
    virtual bool scales_with_object() const { return false; }

    /// Whether it depends on the position alone, so that it can be sampled in slices and volumes.
    virtual bool solid() const { return false; }
};

class Params;
struct ParamSpec;

/// The parameter by which a script sets what `scales_with_object` answers: false by default.
ParamSpec scale_with_object_spec();

/// Makes a procedural from its checked parameters.
using MakeProcedural = std::shared_ptr<const Procedural>(const Params& params);

} // namespace scree
