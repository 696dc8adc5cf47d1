// SPDX-License-Identifier: GPL-3.0-or-later
// What all textures of cells are set up from.
#pragma once

#include "procedurals/solid/cells/hewn_as_cpp.h"
#include "procedurals/solid/solid_specs.h"

#include <algorithm>

namespace scree {

/// Presets hold true lengths in metres, for a lattice `size` of 0.1 m; another size scales them.
inline double preset_scale(const Params& params) { return params.number("size") / 0.1; }

inline solid::Triple as_triple(const Color& c) { return {c.x, c.y, c.z}; }

/// The preset that the parameter `preset` names, of structs with a `name`.
template <class Preset>
const Preset& preset_named(const std::vector<Preset>& presets, const Params& params) {
    return *std::find_if(presets.begin(), presets.end(), [&](const Preset& preset) {
        return preset.name == params.text("preset");
    });
}

/// The parameter `preset`; the first is the default.
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

/// One push by the lattice, `turbulence` in its 64ths; different `use`s take other parts of it,
/// drawn out along the axis by `stretch`.
solid::Push make_push(const Params& params, double turbulence, unsigned use, double stretch = 1);

/// Cells that are `width` wide across the axis and `stretch` times as long along it [m].
solid::Cells make_cells(const Params& params, unsigned use, double width, double stretch = 1,
                        double jitter = 1);

/// A rough surface `height` high [m], whose lattice is `size` wide [m].
solid::Hewn make_hewn(const Params& params, double height, double size, double stretch = 1);

/// The parameter `turbulence`, whose value is the preset's unless given.
ParamSpec turbulence_spec(std::string doc);

/// The text of lattice-driven cells for devices, followed by these.
std::string cells_program(const std::vector<const char*>& texts);

} // namespace scree
