// SPDX-License-Identifier: GPL-3.0-or-later
// Shared setup of all cellular textures.
#pragma once

#include "procedurals/solid/cells/hewn_as_cpp.h"
#include "procedurals/solid/solid_specs.h"

#include <algorithm>

namespace scree {

/// Presets hold real dimensions in metres, which apply at a lattice `size` of 0.1 m; another size
/// scales them.
inline double preset_scale(const Params& params) { return params.number("size") / 0.1; }

inline solid::Triple as_triple(const Color& c) { return {c.x, c.y, c.z}; }

/// The preset named by the parameter `preset`. Preset is a struct with a `name`.
template <class Preset>
const Preset& preset_named(const std::vector<Preset>& presets, const Params& params) {
    return *std::find_if(presets.begin(), presets.end(), [&](const Preset& preset) {
        return preset.name == params.text("preset");
    });
}

/// The declaration of the parameter `preset`; the first preset is the default.
template <class Preset>
ParamSpec preset_choice(const std::vector<Preset>& presets, std::string doc) {
    ParamSpec spec{.name = "preset",
                   .type = ParamType::choice,
                   .doc = std::move(doc),
                   .fallback = presets.front().name};
    for (const Preset& preset : presets)
        spec.choices.push_back(preset.name);
    return spec;
}

/// A domain warp by the lattice, with a strength of `turbulence` in 64ths of its cube. Different
/// `use`s take uncorrelated parts of the lattice, stretched along the axis by `stretch`.
solid::Warp make_warp(const Params& params, double turbulence, unsigned use, double stretch = 1);

/// Cells `width` wide [m] across the axis and `stretch` times as long along it.
solid::Cells make_cells(const Params& params, unsigned use, double width, double stretch = 1,
                        double jitter = 1);

/// A rough surface of `height` [m] per unit of the field, with a lattice cube of `size` [m].
solid::Hewn make_hewn(const Params& params, double height, double size, double stretch = 1);

/// The declaration of the parameter `turbulence`, whose default is that of the preset.
ParamSpec turbulence_spec(std::string doc);

/// The OpenCL source of warped cells, followed by `texts`.
std::string cells_program(const std::vector<const char*>& texts);

} // namespace scree
