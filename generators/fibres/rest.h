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
/// damped steps of at most half a radius, after each of which contact with friction is repeated
/// until nothing is deeper than 0.4 radii, or three times when the steps are at their smallest.
/// Fibres that are deeper than 0.2 radii wait: one that is jammed holds up itself alone.
RestResult come_to_rest(Rods& rods, const Boundary& boundary, const ContactSettings& settings,
                        const Context& context);

} // namespace scree::fibres
