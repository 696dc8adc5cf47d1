// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

namespace scree {

/// What fills a translucent thing, by channel.
struct Medium {
    Color color;          // share of light from all sides that half a space of it gives back
    Color albedo;         // share of light that one scattering leaves
    Color mean_free_path; // between two scatterings [m]
};

/// The medium of which half a space gives `color` back, by the spherical albedo of van de Hulst
/// (1980, "Multiple light scattering"). `distance` [m] is the scale of the spot into which light
/// from all sides that enters at one point spreads; darker media need longer ways for the same
/// (Christensen & Burley 2015, "Approximate reflectance profiles for efficient subsurface
/// scattering", eq. 6).
Medium make_medium(const Color& color, const Color& distance);

} // namespace scree
