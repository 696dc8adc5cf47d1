// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "core/picture.h"
#include "geometry/mesh/mesh.h"
#include "geometry/plane/height_field.h"
#include "geometry/plane/region.h"
#include "model/material.h"

#include <memory>
#include <utility>

namespace scree {

/// One component shape, shared by its instances.
struct Prototype {
    std::string name;
    std::shared_ptr<const Mesh> mesh;         // in its own frame [m]
    std::shared_ptr<const Region> region;     // exclusive region, when the generator has one
    std::shared_ptr<const Material> material; // null: grey matte
    std::shared_ptr<const Picture> picture{}; // what it looks like from above, when it is one
};

/// One element of an aggregate.
struct Instance {
    std::uint32_t prototype = 0;
    // Rounded to float: a generator that promises no overlap leaves room for that rounding.
    Matrix world_from_object;
    float random = 0; // uniform in [0, 1), drives per-instance colour
    double angle = 0; // [rad] as the generator chose it; 0 where it means nothing
    double scale = 1;
};

/// Measured facts in the order in which they are shown: counts, fractions, seconds.
using Facts = std::vector<std::pair<std::string, double>>;

/// What a generator bakes: flat instances over shared prototypes (Debian 12's Embree has one
/// instance level).
struct Aggregate {
    std::string generator; // registry name, "object" for a single object
    Location where{};      // of its constructor in the script
    std::uint64_t seed = 0;
    std::vector<Prototype> prototypes;
    std::vector<Instance> instances;
    std::shared_ptr<const Region> domain;      // when the generator has one
    std::shared_ptr<const HeightField> height; // when the generator makes a relief
    std::shared_ptr<const Picture> background; // fills the domain's bounding box, under all else
    bool torus = false;   // the domain is a rectangle whose opposite sides are one
    bool texture = false; // drawn as exactly the domain's bounding box, without paper or outlines
    Facts facts;
};

} // namespace scree
