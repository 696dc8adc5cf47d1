// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of generator.elements, read once.
#pragma once

#include "geometry/plane/field.h"
#include "geometry/plane/picture_shape.h"
#include "model/file_material.h"

#include <optional>

namespace scree {

/// One component. Its shape is a mesh, a region or a picture.
struct ElementComponent {
    std::shared_ptr<const Mesh> mesh;           // the shape, if it is a mesh
    std::shared_ptr<const Region> flat_shape;   // the shape, if it is a region
    std::optional<PictureShape> picture;        // the shape, if it is a picture
    std::shared_ptr<const Region> given_region; // replaces the shape's own outline; may be null
    Materials materials;
    double weight = 1;
    std::optional<double> length; // semi-axes of the exclusive ellipse, without the margin [m]
    std::optional<double> width;
    double margin = 0; // [m]
    double height = 0; // [m]
    Range turn{0, 0};  // [rad]

    ParamPlace shape_place;
    ParamPlace region_place; // of the region, or of the shape where none is given
    ParamPlace margin_place;
    ParamPlace length_place;
    ParamPlace rotation_place;
};

enum class ElementMix {
    even,  // every component is evenly spread by itself, and all are together
    random // only all are together; each element is any component
};

/// Either a domain or a surface is given.
struct ElementsSettings {
    std::shared_ptr<const Region> domain;
    std::shared_ptr<const Mesh> surface;
    bool torus = false;
    std::vector<ElementComponent> components;
    ElementMix mix = ElementMix::even;
    bool are_disks = false; // the exclusive ellipses
    bool whole_inside = false;
    std::shared_ptr<const Field> direction; // [deg]; null: 0
    std::shared_ptr<const Field> scale;     // null: 1
    std::shared_ptr<const Field> spacing;   // null: 1
    int relax = 0;
    std::string background; // path of a picture; empty: none
    ImageOptions background_options;
    std::uint64_t seed = 0;

    ParamPlace domain_place;
    ParamPlace surface_place;
    ParamPlace torus_place;
    ParamPlace components_place;
    ParamPlace direction_place;
    ParamPlace scale_place;
    ParamPlace spacing_place;
    ParamPlace relax_place;
    ParamPlace background_place;
};

/// Reads parameters that `elements_specs` declares. Throws Error, located, unless there is either a
/// domain or a surface, for a component without shape and picture or with both, and for a picture
/// that cannot be read.
ElementsSettings elements_settings(const Params& params);

} // namespace scree
