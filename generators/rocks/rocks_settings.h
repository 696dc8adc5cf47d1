// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "generators/rocks/ground.h"
#include "generators/rocks/rock_sizes.h"
#include "geometry/plane/field.h"
#include "geometry/plane/region.h"
#include "geometry/rock/rock_settings.h"
#include "model/material.h"

#include <optional>

namespace scree::rocks {

enum class Method { paper, mosaic, dropped };

enum class Distribution { classes, power, area };

/// Eqs. 2 and 3 of Sakurai & Miyata for a class: base, spread among rocks, spread among vertices.
struct Swelling {
    WideVec3 widening{0, 0, 0}; // c_w1 to c_w3 [m]
    WideVec3 height{0, 0, 0};   // c_h1 to c_h3 [m]
};

/// All that generator.rocks's parameters ask for.
struct RocksSettings {
    Method method = Method::dropped;
    std::shared_ptr<const Region> domain;
    ParamPlace domain_place;

    std::vector<SizeClass> classes;
    std::vector<Swelling> swellings; // of each class, for the paper's method
    Distribution distribution = Distribution::classes;
    double smallest = 0; // longest axis [m]
    double largest = 0;
    double exponent = 2.5;
    double cover = 1; // plan area of all rocks, as a share of the domain's

    RockSettings rock;
    double spread = 0.12;      // of the axes among rocks, standard deviation
    double wear_spread = 0.08; // of the wear, likewise
    double joint = 0.0006;     // between mosaic rocks [m]

    std::shared_ptr<const Mesh> ground; // null: a plane
    ParamPlace ground_place;
    double slope = 0; // of the plane [rad]
    double burial = 0.15;
    double dip = 0;                       // [rad]
    double flow = 0;                      // [rad]
    double sorting = 0;                   // by how much ln D falls for a metre of height [1/m]
    std::shared_ptr<const Field> density; // may be null
    std::shared_ptr<const Field> size;    // by how much ln D is greater by place; may be null

    int level = 0; // of all meshes; 0: by size
    int prototypes = 64;
    bool unique = false;
    bool half_exclusion = true; // paper: sites keep r / 2 apart as in its text, not r
    std::size_t measure = 0;

    Materials materials;                             // of the shapes, in turn; empty: the default
    std::shared_ptr<const Material> ground_material; // null: the ground is not shown
    std::uint64_t seed = 0;
};

/// Reads the parameters. Throws Error, located, for values that do not go together.
RocksSettings rocks_settings(const Params& params);

} // namespace scree::rocks
