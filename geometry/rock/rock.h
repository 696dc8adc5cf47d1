// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/rock/rock_relief.h"

#include <functional>

namespace scree {

/// A rock as a radius in every direction, drawn at any level of detail. Its mesh is closed and
/// never meets itself, whatever the parameters: its vertices are those of a sphere, moved along
/// rays from one point inside.
///
/// Frame: the axes a, b, c lie along x, z, y; half of a is 1; the centre is the origin.
class Rock {
  public:
    explicit Rock(const RockSettings& settings);

    /// A rock that half-spaces bound. They are of the body's frame, as are the axes by which it is
    /// multiplied: x, y and upright z, which are x, -z and y here.
    Rock(const RockSettings& settings, std::vector<RockPlane> cut, const WideVec3& axes);

    /// The surface in a direction of length 1, without what is finer than the wavelength
    /// `shortest`.
    WideVec3 surface(const WideVec3& direction, double shortest) const;

    /// A vertex in each direction of geodesic_sphere(level). Relief enters where its waves are
    /// longer than two edges.
    /// @param limit the farthest that the surface may be in a direction of length 1; empty: no
    /// limit
    std::vector<WideVec3> vertices(int level,
                                   const std::function<double(const WideVec3&)>& limit = {}) const;

  private:
    Random random_;
    RockBody body_;
    RockRelief relief_;
    WideVec3 axes_; // of the body's frame, whose box they make as large as the settings say
};

/// The mesh of 20 level^2 triangles with these vertices, level from 1 to 128, with smooth normals
/// and the UVs of GeodesicSphere.
Mesh rock_mesh(const std::vector<WideVec3>& vertices, int level);

} // namespace scree
