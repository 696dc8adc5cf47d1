// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "core/warn.h"
#include "generators/fibres/fibre_shape.h"
#include "geometry/mesh/mesh.h"
#include "model/material.h"

#include <optional>

namespace scree::fibres {

enum class Adjustment { none, thesis, nearest };

/// How fibres are brought out of each other, and to rest.
struct ContactSettings {
    double radius = 0.01;    // of fibres [m]; lengths below are in radii
    double tolerance = 0.05; // how deep fibres may be in each other and in what bounds them
    double stiffness = 0.2;  // of joints, share that a sweep restores
    double friction = 0.5;   // Coulomb's coefficient
    int max_iterations = 500;
};

/// All that generator.fibres's parameters ask for.
struct FibresSettings {
    std::shared_ptr<const Mesh> target; // null with roots
    ParamPlace target_place;
    std::shared_ptr<const Mesh> roots; // null: fibres fill the target
    std::size_t count = 2048;
    FibreShape shape;
    std::optional<FibreFlow> flow;
    Adjustment adjustment = Adjustment::nearest;
    bool contact = true;
    bool gravity = false;
    ContactSettings contact_settings;
    std::shared_ptr<const Mesh> container; // may be null
    std::optional<double> floor;           // height [m]
    bool spline = false;                   // fibres become cubic B-splines
    Materials materials;
    std::uint64_t seed = 1;
    Warn warn; // of what contact did not meet

    /// Volume of all fibres as a share of the target's; 0 without one.
    double fill() const;
};

/// Reads the parameters. Throws Error, located, for values that do not go together.
FibresSettings fibres_settings(const Params& params);

} // namespace scree::fibres
