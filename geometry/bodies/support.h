// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/contact_graph.h"

namespace scree {

/// Which bodies would not stay where they are; a flag for each body.
struct Support {
    std::vector<char> floating;    // no chain of contacts leads from it to the ground
    std::vector<char> unsupported; // one does, but its centre of mass is not over the convex hull
                                   // of the places where it is held up
    std::vector<char> falling;     // both of these, and what falls once they are gone
};

/// Which bodies would fall. Gravity is along -y. Friction is taken to be enough everywhere, and any
/// support to bear any load: each body is judged by itself, so that whole towers do not topple.
/// What sticks to the target stays.
Support support_of(const ContactGraph& graph);

/// The number of groups of touching bodies that are left when the ground is taken away.
std::size_t contact_groups(const ContactGraph& graph);

/// The mean number of others that a body touches.
double mean_contacts(const ContactGraph& graph);

} // namespace scree
