// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/elements/elements_settings.h"
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
    double height = 0;  // above the ground or surface [m]
    Range turn{0, 0};   // [rad]
    ElementRoom room;   // both ellipses with the margin
    bool sized = false; // the script gives the exclusive ellipse, which otherwise follows from what
                        // the element fills
};

/// Throws Error, located, for a mesh without a silhouette, a region without area, a margin that
/// leaves nothing, and evenly mixed components of which only some have their sizes given.
std::vector<ElementShape> element_shapes(const ElementsSettings& settings);

/// The classes that the components are sampled as. Mixed evenly: one each; where the sizes were
/// derived they are spread by `class_sizes`, and the ellipses keep their proportions. Mixed at
/// random: one whose ellipse holds all; throws Error, located, when components' turns differ.
std::vector<DiskClass> disk_classes(const ElementsSettings& settings,
                                    const std::vector<ElementShape>& shapes);

} // namespace scree
