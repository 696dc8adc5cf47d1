// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/contact_graph.h"

namespace scree {

/// What would not stay where it is.
struct Support {
    std::vector<char> floating;    // no way of contacts to the ground
    std::vector<char> unsupported; // the ground is in touch, but its centre of mass is not over the
                                   // convex hull of what holds it up
    std::vector<char> falling;     // all that come down once these have, and what rests on them
};

/// Which components fall. Gravity is -y; friction is thought to be enough everywhere, and what
/// holds one component up to bear any load, so that whole towers do not topple. What sticks to the
/// target stays.
Support support_of(const ContactGraph& graph);

/// In how many groups of touching components the pile comes apart when the ground is taken away.
std::size_t contact_groups(const ContactGraph& graph);

/// Mean number of others that a component touches.
double mean_contacts(const ContactGraph& graph);

} // namespace scree
