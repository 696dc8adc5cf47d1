// SPDX-License-Identifier: GPL-3.0-or-later
// How what is read from a file comes into the scene, for mesh.file and curve.file.
#pragma once

#include "core/params.h"

#include <string>
#include <vector>

namespace scree {

/// The parameters that say it: unit, size, centre and up. `known`: a sentence on the format whose
/// unit is always known.
std::vector<ParamSpec> placement_specs(const std::string& known);

/// Takes points of a file, in double precision, to where the parameters put them [m].
class FilePlacement {
  public:
    /// `box`: of all points, not empty. `known`: why they are in metres, or "" when the file does
    /// not say. Throws Error at `unit` when one is given although it is known.
    FilePlacement(const Params& params, const Imath::Box3d& box, const std::string& known);

    Imath::V3d operator()(const Imath::V3d& p) const {
        return (turned(p * unit_) - foot_) * factor_;
    }

    /// A direction, such as a normal.
    Vec3 turned(const Vec3& v) const { return z_up_ ? Vec3(v.x, v.z, -v.y) : v; }

    /// By what lengths are multiplied.
    double scale() const { return unit_ * factor_; }

    /// Whether it is moved to the origin.
    bool centred() const { return centred_; }

    /// Whether nothing says in which unit it is, or how large.
    bool unit_unknown() const { return unit_unknown_; }

  private:
    Imath::V3d turned(const Imath::V3d& v) const { return z_up_ ? Imath::V3d(v.x, v.z, -v.y) : v; }

    double unit_ = 1; // [m]
    bool z_up_ = false;
    bool centred_ = false;
    bool unit_unknown_ = false;
    Imath::V3d foot_{0.0, 0.0, 0.0}; // what is moved to the origin [m]
    double factor_ = 1;
};

} // namespace scree
