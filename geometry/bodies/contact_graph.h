// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/advance.h"

#include <optional>

namespace scree {

/// Where a component is touched by another.
struct Contact {
    std::uint32_t other = 0;
    std::vector<Vec2> supports; // corners (x, z), from its centre of mass, of where that holds it
                                // up [m]; none where it only touches its side or top
};

/// Who touches whom, and what holds them.
struct ContactGraph {
    std::vector<std::vector<Contact>> contacts; // by component
    std::vector<char> anchored;                 // those that stick to the target
    std::vector<std::vector<Vec2>> floor;       // as Contact::supports, on the floor

    std::size_t size() const { return contacts.size(); }
    bool on_ground(std::size_t i) const { return anchored[i] != 0 || !floor[i].empty(); }
};

/// What touches what.
struct ContactSettings {
    double tolerance = 0.05; // gap that counts as touching, in radii of the smaller's largest
                             // inner ball; beyond 0.08, where the distance's
                             // grid ends, up to 1.4 times as much counts
    const Mesh* adhesive = nullptr; // a surface that all stick to that touch it
    std::optional<double> floor{};  // height [m] of a level plane that they stand on
};

/// The contacts of a pile, by dense samples of the true meshes in the neighbours' signed distance.
/// A contact holds up where it pushes upwards: its surface is not steeper than 84 degrees.
ContactGraph contact_graph(const Pile& pile, const ContactSettings& settings);

/// The height of the pile's lowest point [m].
double lowest_point(const Pile& pile);

/// The centre of mass of a closed mesh of even density; of an open one that of its surface.
Imath::V3d mass_centre(const Mesh& mesh, bool closed);

} // namespace scree
