// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/placed_bodies.h"

#include <optional>

namespace scree {

/// That a body touches another one.
struct Contact {
    std::uint32_t other = 0;
    // The convex area on which the other one holds it up: corners (x, z) relative to its centre of
    // mass [m]. Empty where the other one only touches it from the side or from above.
    std::vector<Vec2> supports;
};

/// Which bodies touch, and what holds them; all by their numbers in `PlacedBodies::all`.
struct ContactGraph {
    std::vector<std::vector<Contact>> contacts;
    std::vector<char> anchored;           // whether it sticks to the target
    std::vector<std::vector<Vec2>> floor; // the area on which the floor holds it up, likewise

    std::size_t size() const { return contacts.size(); }
    bool on_ground(std::size_t i) const { return anchored[i] != 0 || !floor[i].empty(); }
};

/// What counts as a contact.
struct ContactSettings {
    // The gap that still counts as touching, in radii of the smaller one's largest inner ball.
    // Outside of its grid a distance is a bound from below, so that of a setting beyond 0.08 gaps
    // of up to 1.4 times as much count.
    double tolerance = 0.05;
    const Mesh* adhesive = nullptr; // if any, a surface to which every body sticks that touches it
    std::optional<double> floor{};  // height of a level floor [m]
};

/// The contacts of all bodies, found by dense samples of each mesh in the others' signed distances.
/// A contact holds a body up where it pushes upwards: where the surface below is not steeper than
/// 84 degrees.
ContactGraph contact_graph(const PlacedBodies& bodies, const ContactSettings& settings);

/// The height of the lowest point of all bodies [m].
double lowest_point(const PlacedBodies& bodies);

} // namespace scree
