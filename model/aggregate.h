// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "core/picture.h"
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/strands.h"
#include "geometry/plane/height_field.h"
#include "geometry/plane/region.h"
#include "model/material.h"

#include <memory>
#include <utility>
#include <variant>

namespace scree {

/// What a component looks like; a null mesh is nothing to see.
using Shape = std::variant<std::shared_ptr<const Mesh>, std::shared_ptr<const Strands>>;

/// One component, shared by its instances.
struct Prototype {
    std::string name{};
    Shape shape{};                            // in object space [m]
    std::shared_ptr<const Region> region{};   // exclusive region, if the generator has one
    Materials materials{};                    // one, or one for each part of the mesh
    std::shared_ptr<const Picture> picture{}; // set when it is a flat picture: its view from above
    std::shared_ptr<const Region> outline{};  // its shape from above where that is not the region

    /// Null when the shape is of another kind, or there is none.
    const Mesh* mesh() const {
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape);
        return mesh == nullptr ? nullptr : mesh->get();
    }
    const Strands* strands() const {
        const auto* strands = std::get_if<std::shared_ptr<const Strands>>(&shape);
        return strands == nullptr ? nullptr : strands->get();
    }
};

/// One element of an aggregate.
struct Instance {
    std::uint32_t prototype = 0;
    // The renderer rounds it to float, relative to the camera; a generator that guarantees no
    // overlap allows for the rounding error.
    WideMatrix world_from_object;
    float random = 0; // uniform in [0, 1), drives per-instance colour
    double angle = 0; // [rad] as chosen by the generator; 0 where it has no meaning
    double scale = 1;
};

/// Named measurements in the order in which they are shown: counts, fractions, seconds.
using Facts = std::vector<std::pair<std::string, double>>;

/// The output of a generator: shared prototypes and one level of instances (Debian 12's Embree
/// supports only one).
struct Aggregate {
    std::string generator; // registry name, "object" for a single object
    std::string name{};    // given in the script; may be empty
    Location where{};      // of its constructor in the script
    std::uint64_t seed = 0;
    std::vector<Prototype> prototypes;
    std::vector<Instance> instances;
    std::shared_ptr<const Region> domain;      // if the generator has one
    std::shared_ptr<const HeightField> height; // if the generator makes a relief
    std::shared_ptr<const Picture> background; // fills the domain's bounding box, below all else
    bool torus = false;   // the domain is a rectangle whose opposite sides are identified
    bool texture = false; // drawn as exactly the domain's bounding box, without paper or outlines
    Facts facts;
};

/// How an aggregate is called in messages: `layout`, or `layout "sweets"` when it has a name.
inline std::string title(const Aggregate& aggregate) {
    return aggregate.name.empty() ? aggregate.generator
                                  : aggregate.generator + " \"" + aggregate.name + '"';
}

} // namespace scree
