// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of layouts from above, x to the right and z down.
#pragma once

#include "core/image.h"
#include "model/aggregate.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace scree {

/// What a drawing shows.
struct LayoutLook {
    int pixels = 1600;   // the longer side of an image
    bool margins = true; // exclusive regions that are not the shapes themselves, as thin lines
};

/// Gives the display-encoded colour of an element.
using ElementColor = std::function<Color(const Aggregate& aggregate, const Instance& instance)>;

/// The part of the ground that a picture of the aggregates shows [m]: the bounding box of domains,
/// regions and pictures with a border of 1/50 of its longer side; for tiles exactly the bounding
/// box of the domains. Throws Error when no aggregate has a domain, a region or a picture.
Box2 picture_box(std::span<const Aggregate> aggregates);

/// Whether the aggregate is drawn as exactly its domain's bounding box, without an outline: a
/// texture, or a torus, whose picture repeats without a seam.
bool is_tile(const Aggregate& aggregate);

/// Whether all of them are textures, which are drawn without paper and ground.
bool are_textures(std::span<const Aggregate> aggregates);

/// What is drawn of a prototype with a region: its shape from above, without margin.
const Region& seen_region(const Prototype& prototype);

/// Whether the exclusive region is more, or other, than the shape, and is drawn too.
bool has_margin(const Prototype& prototype);

/// The bounding box of the prototype's region and picture in its own frame [m]; may be empty.
Box2 prototype_box(const Prototype& prototype);

/// The shifts [m] at which an aggregate is drawn: (0, 0), and on a torus also those of the eight
/// neighbouring periods.
std::vector<Vec2> picture_shifts(const Aggregate& aggregate);

/// Whether the element drawn at this shift may be visible. On a torus and in a texture it is when
/// the box around its bounding circle meets the domain's bounding box.
bool is_seen(const Aggregate& aggregate, const Instance& instance, const Vec2& shift);

/// SVG 1.1, in millimetres: for every prototype a <path> (with holes) or a <symbol> (with its
/// picture) in <defs>, for every instance a <use> with its matrix, and the outlines of the domains
/// that are no tiles.
/// Margins are a group of their own.
/// On a torus the periodic copies are included, clipped to the domain.
std::string layout_svg(std::span<const Aggregate> aggregates, const ElementColor& color,
                       const LayoutLook& look = {});

/// The same as an anti-aliased image: linear, premultiplied R, G, B, A. The shorter side is rounded
/// to whole pixels, so that the period of a texture is whole too.
Image layout_image(std::span<const Aggregate> aggregates, const ElementColor& color,
                   const LayoutLook& look);

} // namespace scree
