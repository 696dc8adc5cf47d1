// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fabrication/level_surface.h"

namespace scree {

/// One closed surface of several: a body's outside, or a void within a body.
struct Shell {
    static constexpr std::uint32_t none = 0xffffffff;

    double volume = 0;           // enclosed, in units of the lattice; negative for a void
    std::uint32_t parent = none; // the shell just outside of it
    std::size_t triangles = 0;

    bool is_void() const { return volume < 0; }
};

struct Shells {
    std::vector<Shell> list;              // by their first vertex
    std::vector<std::uint32_t> of_vertex; // index into the list
};

/// The connected parts of a surface that does not meet itself, and which lies within which.
Shells find_shells(const LevelSurface& surface);

} // namespace scree
