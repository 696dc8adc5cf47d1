// SPDX-License-Identifier: GPL-3.0-or-later
// What a material's paint says of a hit: its colour, its roughness and its bumped normal.
#pragma once

#include "model/material.h"
#include "render/bsdf/painted.h"
#include "render/world/world.h"

#include <span>

namespace scree {

/// What a texture's lengths are measured in, in the object's frame: units of the object, with which
/// it grows, or metres of the world.
enum class TextureUnit { object, world };

/// Where a procedural is evaluated for a hit that was reached along `direction`: the pixel's
/// filter, a square `footprint` wide [m] that faces the ray, is projected onto the surface and
/// taken to the object's frame. Not for hits on lights.
ShadingPoint shading_point(const Hit& hit, const Vec3& direction, float footprint,
                           TextureUnit unit = TextureUnit::world);

/// The shading normal of the surface raised by a height whose gradient in the object's frame is
/// `slope` (Mikkelsen 2010: the surface gradient). Heights in units of the object are lengths along
/// the normal in its frame: they turn, scale and shear with it.
Vec3 bent_normal(const Hit& hit, const Vec3& slope, TextureUnit unit = TextureUnit::world);

/// A hit whose paint is wanted; it was reached along `direction` and is seen with a filter
/// `footprint` wide [m].
struct PaintQuery {
    const Paint* paint;
    const Hit* hit;
    Vec3 direction;
    float footprint;
};

/// The most queries that `paint` takes.
constexpr std::size_t most_painted = 8;

/// Answers each query. Every procedural is asked about all its hits together, which some answer
/// faster than one by one.
void paint(std::span<const PaintQuery> queries, std::span<Painted> painted);

} // namespace scree
