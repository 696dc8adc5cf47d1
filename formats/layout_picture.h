// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts seen from above, x to the right and z down, as drawings.
#pragma once

#include "core/image.h"
#include "model/aggregate.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace scree {

/// The display-encoded colour that an element is drawn with.
using ElementColor = std::function<Color(const Aggregate& aggregate, const Instance& instance)>;

/// The part of the ground that a picture of the aggregates shows [m]: domains, regions and pictures
/// with a border of a fiftieth; of textures exactly the domains' bounding boxes. Throws Error when
/// no aggregate has a domain, a region or a picture.
Box2 picture_box(std::span<const Aggregate> aggregates);

/// Whether all of them are textures: drawn on nothing, without outlines.
bool are_textures(std::span<const Aggregate> aggregates);

/// What an element covers in its prototype's frame, region and picture [m]; may be empty.
Box2 prototype_box(const Prototype& prototype);

/// The shifts [m] at which an aggregate is drawn: (0, 0), and on a torus those of its neighbours.
std::vector<Vec2> picture_shifts(const Aggregate& aggregate);

/// Whether the element drawn at this shift can be seen, judged by its bounding circle: on a torus
/// and in a texture only what reaches into the domain's bounding box.
bool is_seen(const Aggregate& aggregate, const Instance& instance, const Vec2& shift);

/// SVG 1.1, in millimetres: one <path> with its holes, or one <symbol> with its picture, per
/// prototype in <defs>, one <use> with the element's matrix per instance, and the domains'
/// outlines. On a torus the copies of elements around are there too, clipped at the domain.
std::string layout_svg(std::span<const Aggregate> aggregates, const ElementColor& color);

/// The same as a picture of `longest_side` pixels, anti-aliased: R, G, B, A, linear and multiplied
/// by alpha. The shorter side is rounded to whole pixels, so that a texture's period is whole too.
Image layout_image(std::span<const Aggregate> aggregates, const ElementColor& color,
                   int longest_side);

} // namespace scree
