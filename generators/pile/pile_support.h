// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/placed_bodies.h"
#include "model/aggregate.h"

#include <optional>

namespace scree {

/// What is done about components that would not stay where they are.
enum class SupportCheck { none, report, remove };

/// How a pile's support is checked.
struct SupportSettings {
    SupportCheck check = SupportCheck::none;
    bool adhesive = true;          // components that touch the target stick to it
    std::optional<double> floor{}; // height of a level floor in the target's frame [m]
    double contact = 0.2;          // gap that counts as touching, as `ContactSettings::tolerance`
};

/// Checks the support of the pile on its target as the settings say, adds what it finds to the
/// facts and, if asked to, removes the components that would fall.
void check_support(PlacedBodies& pile, const Mesh& target, const SupportSettings& settings,
                   Facts& facts);

} // namespace scree
