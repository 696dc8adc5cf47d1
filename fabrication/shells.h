// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fabrication/level_surface.h"

namespace scree {

/// One connected closed surface: the outside of a body, or a void inside a body.
struct Shell {
    static constexpr std::uint32_t none = 0xffffffff;

    double volume = 0;           // enclosed, in units of the lattice; negative for a void
    std::uint32_t parent = none; // the innermost shell around it
    std::size_t triangles = 0;

    bool is_void() const { return volume < 0; }
};

struct Shells {
    std::vector<Shell> list;              // in order of their first vertices
    std::vector<std::uint32_t> of_vertex; // index into the list
};

/// The connected components of a surface without self-intersections, and their nesting.
Shells find_shells(const LevelSurface& surface);

} // namespace scree
