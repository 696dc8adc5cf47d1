// SPDX-License-Identifier: GPL-3.0-or-later
// Components made of a picture: shape, outline and looks from one file.
#pragma once

#include "core/params.h"
#include "core/picture.h"
#include "geometry/mesh/mesh.h"
#include "geometry/plane/region.h"

namespace scree {

/// A picture cut out along what is opaque in it.
struct PictureShape {
    std::shared_ptr<const Picture> picture; // its box lies so that it coincides with the outline
    std::shared_ptr<const Region> region;   // where alpha is at least a half
    std::shared_ptr<const Mesh> mesh;       // the region, flat; the whole picture is its UV square
};

/// The picture's outline, its longest side `size` [m] and the middle of its bounding box at the
/// origin; the whole rectangle for a picture without alpha. Throws Error when less than 4 square
/// pixels are opaque, and for an outline of more than 500,000 points.
PictureShape picture_shape(Picture picture, double size);

/// What a component that may be a picture declares: `picture` (a path), `size` [m] and
/// `resolution`, all optional.
std::vector<ParamSpec> picture_specs();

/// Reads the picture that such a component names; its parameters are `picture_specs` and others.
/// Throws Error, located at the parameter, also when `size` is missing.
PictureShape picture_shape(const Params& component);

} // namespace scree
