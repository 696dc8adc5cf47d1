// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that all solid textures share.
#pragma once

#include "core/params.h"
#include "procedurals/reflectance.h"
#include "procedurals/solid/lattice/fractal_lattice.h"
#include "procedurals/solid/solid_as_cpp.h"

namespace scree {

/// `own`, then those of the fractal field and of where it lies.
std::vector<ParamSpec> solid_specs(std::vector<ParamSpec> own);

std::shared_ptr<const FractalLattice> make_lattice(const Params& params);

/// Right-handed unit vectors of the texture in the object's frame; the last is the parameter
/// `axis`. Throws Error at `axis` when it has no direction.
struct SolidFrame {
    Vec3 right, up, axis;
    Vec3 origin; // [m]
};
SolidFrame solid_frame(const Params& params);

/// The lattice in that frame: `size` wide, drawn out along the axis by `stretch`. Different `use`s
/// of one lattice lie so far apart and so turned that they have nothing to do with one another; 0
/// is the lattice as it stands, its corner at the origin.
solid::Placement placement(const Params& params, const SolidFrame& frame, unsigned use,
                           double scale = 1, double stretch = 1);

/// Length of one unit of `turbulence`: of a cell in the paper's lattice of 64 [m].
double cell_length(const Params& params);

inline solid::Triple as_triple(const Vec3& v) { return {v.x, v.y, v.z}; }
inline float as_float(double v) { return static_cast<float>(v); }

/// An optional number: the parameter's, or what a preset says.
inline double number_or(const Params& params, const std::string& name, double otherwise) {
    return params.has(name) ? params.number(name) : otherwise;
}
inline Color color_or(const Params& params, const std::string& name, const Color& otherwise) {
    return params.has(name) ? reflectance(params, name) : otherwise;
}

/// The specs of such parameters: without a value unless given.
ParamSpec preset_number(std::string name, std::string doc, std::string unit, double min,
                        double max);
ParamSpec preset_color(std::string name, std::string doc);

} // namespace scree
