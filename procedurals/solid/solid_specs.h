// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that all solid textures share.
#pragma once

#include "core/params.h"
#include "procedurals/reflectance.h"
#include "procedurals/solid/lattice/fractal_lattice.h"
#include "procedurals/solid/solid_as_cpp.h"

namespace scree {

/// The given parameters, followed by those of the fractal field and its placement.
std::vector<ParamSpec> solid_specs(std::vector<ParamSpec> specs);

std::shared_ptr<const FractalLattice> make_lattice(const Params& params);

/// The right-handed orthonormal frame of the texture in object space; `axis` is the parameter of
/// that name.
struct SolidFrame {
    Vec3 right, up, axis;
    Vec3 origin; // [m]
};
SolidFrame solid_frame(const Params& params);

/// The placement of the lattice in that frame: `size` times `scale` wide and stretched along the
/// axis by `stretch`. Different `use`s have random offsets and rotations, so that they are
/// uncorrelated; use 0 is the unrotated lattice with its corner at the origin.
solid::Placement placement(const Params& params, const SolidFrame& frame, unsigned use,
                           double scale = 1, double stretch = 1);

/// Length of one unit of `turbulence` [m]: that of a cell of the paper's lattice of 64.
double cell_length(const Params& params);

inline solid::Triple as_triple(const Vec3& v) { return {v.x, v.y, v.z}; }
inline float as_float(double v) { return static_cast<float>(v); }

/// An optional number: the parameter if given, otherwise that of a preset.
inline double number_or(const Params& params, const std::string& name, double otherwise) {
    return params.has(name) ? params.number(name) : otherwise;
}
inline Color color_or(const Params& params, const std::string& name, const Color& otherwise) {
    return params.has(name) ? reflectance(params, name) : otherwise;
}

/// The declarations of such optional parameters.
ParamSpec preset_number(std::string name, std::string doc, std::string unit, double min,
                        double max);
ParamSpec preset_color(std::string name, std::string doc);

} // namespace scree
