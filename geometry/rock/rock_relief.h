// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "geometry/rock/rock_body.h"

namespace scree {

/// What stands out of a rock's body or is let into it: beds, small broken faces, self-affine
/// roughness and cracks. Noise in space, so that it runs on across edges.
class RockRelief {
  public:
    RockRelief(const RockSettings& settings, const std::array<WideVec3, 3>& joints, Random& random);

    /// The height at a place of the body, both in halves of the longest axis. What is finer than
    /// the wavelength `shortest` is left out, fading over one octave.
    double height(const WideVec3& place, double shortest) const;

  private:
    struct Crack {
        WideVec3 normal;
        double offset, width, depth;
    };

    double beds(const WideVec3& place, double shortest) const;
    double broken_faces(const WideVec3& place, double shortest) const;
    double roughness(const WideVec3& place, double shortest) const;
    double cracked(const WideVec3& place, double shortest) const;

    RockSettings settings_;
    double fresh_; // how much of what breaking leaves is not worn off
    std::uint32_t noise_;
    WideVec3 bedding_; // normal of the beds
    std::vector<Crack> cracks_;
};

} // namespace scree
