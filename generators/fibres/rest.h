// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/fibres/contact.h"

namespace scree::fibres {

/// What came of falling.
struct RestResult {
    int steps = 0;
    int passes = 0;       // of contact
    double mean_step = 0; // of vertices in the last step [radii]
    bool at_rest = false;
};

/// Lets fibres fall until the mean step of their vertices is below a thousandth of the radius:
/// damped steps of at most half a radius, after each of which contact is brought below a fifth of
/// a radius, with Coulomb friction against what slid in the step.
RestResult come_to_rest(Rods& rods, const Boundary& boundary, const ContactSettings& settings,
                        const Context& context);

} // namespace scree::fibres
