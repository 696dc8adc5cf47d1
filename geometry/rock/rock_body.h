// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"
#include "core/random.h"
#include "geometry/rock/rock_settings.h"

#include <array>
#include <vector>

namespace scree {

/// All points x with normal . x <= height.
struct RockPlane {
    WideVec3 normal;
    double height = 1;
    double sharpness = 1; // its own factor of the gauge's exponent
};

/// The large shape of a rock, as a radius in each direction from its centre, in a frame in which
/// its axes are of length 1. Half-spaces of three joint sets, further faces and chips are joined by
/// a gauge function: with p the exponent, 1 / radius = (sum of max(0, n.d / h)^p)^(1/p). A large p
/// leaves their edges sharp; a small one is the closed form of wear, which takes edges before it
/// shortens axes, the first phase of abrasion; in the second all of the surface wears towards an
/// ellipsoid (Bloore 1977). Scars are hollows by smooth minimum with balls.
class RockBody {
  public:
    /// `cut`: half-spaces that bound the body beside its own, such as those of a cell of ground.
    RockBody(const RockSettings& settings, Random& random, std::vector<RockPlane> cut = {});

    /// The radius in a direction of length 1; at least 0.2.
    double radius(const WideVec3& direction) const;

    /// The normals of the three joint sets.
    const std::array<WideVec3, 3>& joints() const { return joints_; }

  private:
    struct Scar {
        WideVec3 centre;
        double radius;
    };

    /// The larger of n.d / h over all planes: 1 / radius of the body with sharp edges.
    double sharp_gauge(const WideVec3& direction) const;
    double gauge(const WideVec3& direction, double exponent) const;
    double hollowed(const WideVec3& direction, double radius) const;
    WideVec3 protruding(Random& random, int tries) const;
    void add_faces(const RockSettings& settings, Random& random);
    void add_chips(const RockSettings& settings, Random& random);
    void add_scars(const RockSettings& settings, Random& random);

    double wear_ = 0;
    double exponent_ = 1;
    double rounded_ = 0; // share of an ellipsoid
    std::uint32_t noise_ = 0;
    std::array<WideVec3, 3> joints_;
    std::vector<RockPlane> planes_;
    std::vector<Scar> scars_;
};

/// A direction of length 1, any as likely.
WideVec3 random_direction(Random& random);

/// Three independent numbers of the standard normal distribution.
WideVec3 normal_vector(Random& random);

} // namespace scree
