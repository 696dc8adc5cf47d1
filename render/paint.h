// SPDX-License-Identifier: GPL-3.0-or-later
// What a material's paint says of a hit: its colour, its roughness and the bend of its normal.
#pragma once

#include "model/material.h"
#include "render/world/world.h"

#include <span>

namespace scree {

/// Where a procedural is asked about a hit that was reached along `direction`: the pixel's filter,
/// a square `footprint` wide [m] that faces the ray, laid onto the surface and taken to the
/// object's frame. Not for hits on lights.
ShadingPoint shading_point(const Hit& hit, const Vec3& direction, float footprint);

/// The shading normal over a height whose gradient in the object's frame is `slope`: heights are
/// lengths of the object along its own normal, and turn, grow and shear with it (Mikkelsen 2010:
/// the surface gradient).
Vec3 bent_normal(const Hit& hit, const Vec3& slope);

/// What there is to know before light.
struct Painted {
    Color color{0.0F, 0.0F, 0.0F};
    float roughness = ShadingSample::unset; // the material's own
    bool bent = false;                      // `normal` takes the place of the shading normal
    Vec3 normal{0.0F, 0.0F, 0.0F};          // unit, on the side of the geometric normal's outside
};

/// A hit whose paint is asked for, reached along `direction` and seen with a filter `footprint`
/// wide [m].
struct PaintQuery {
    const Paint* paint;
    const Hit* hit;
    Vec3 direction;
    float footprint;
};

/// Answers up to `most_painted` queries, a sample to each; every procedural is asked about its hits
/// together, which some answer faster than one by one.
constexpr std::size_t most_painted = 8;
void paint(std::span<const PaintQuery> queries, std::span<Painted> painted);

} // namespace scree
