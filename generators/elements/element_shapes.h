// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "generators/elements/exclusive_ellipse.h"
#include "geometry/sampling/poisson_disk.h"
#include "model/aggregate.h"

namespace scree {

/// One component, and the room that each of its elements needs.
struct ElementShape {
    Prototype prototype;
    Vec2 centre;        // of the region's bounding box, in the prototype's frame [m]
    double area = 0;    // of the region [m^2]
    double reach = 0;   // of the region from its centre, and the margin [m]
    double weight = 1;  // its share of all elements, relative to the others
    double height = 0;  // [m]
    Range turn{0, 0};   // [rad]
    ElementRoom room;   // what it fills, and its exclusive ellipse, margin included
    bool sized = false; // the latter is given, otherwise derived from the former
};

/// Reads generator.elements' components. Throws Error, located, for a component without shape and
/// picture or with both, a picture that cannot be read, a mesh without a silhouette, a region
/// without area, a margin that leaves nothing, and components of which only some are sized while
/// they are mixed evenly.
std::vector<ElementShape> element_shapes(const Params& params);

/// The classes that the components are sampled as. Mixed evenly: one each; where the sizes were
/// derived they are spread by `class_sizes`, and the ellipses keep their proportions. Mixed at
/// random: one whose ellipse holds all; throws Error, located, when components' turns differ.
std::vector<DiskClass> disk_classes(const Params& params, const std::vector<ElementShape>& shapes);

} // namespace scree
