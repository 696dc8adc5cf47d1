// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/pile/component_settings.h"
#include "generators/pile/fill_solid.h"
#include "generators/pile/orientation_flow.h"
#include "generators/pile/pile_cut.h"
#include "generators/pile/pile_sites.h"
#include "generators/pile/pile_support.h"
#include "generators/pile/relax.h"
#include "generators/pile/thesis_method.h"

#include <functional>

namespace scree {

/// All that generator.pile's parameters ask for. Lengths and directions are in the target's frame,
/// which `position` and `turn` place in the scene together with the finished pile.
struct PileSettings {
    std::shared_ptr<const Mesh> target;
    ParamPlace target_place;
    WideVec3 position{0, 0, 0}; // of the target's origin in the scene [m]
    double turn = 0;            // about the upright axis [rad]

    std::vector<ComponentSettings> components;
    PileFrame frame = PileFrame::surface;
    std::optional<OrientationFlow> flow;

    // How components are placed: by the thesis's method, by relaxation or, with neither, by
    // insertion alone.
    std::optional<ThesisSettings> thesis;
    std::optional<RelaxSettings> relaxation;
    InsertionSettings insertion; // of what relaxation leaves room for, too
    std::optional<SettleSettings> settling;
    std::optional<SolidFill> solid; // nothing: only the surface is covered
    double cover = 0;               // the share of the surface to be hidden; 0: one pass
    std::function<void(std::string)> warn_of_cover{}; // where a certain share was asked for

    SupportSettings support;
    std::optional<CutPlane> cut;
    std::size_t measure = 0; // how many components the overlap is measured at
    std::uint64_t seed = 0;
};

/// Reads the parameters. Throws Error, located, for values that do not go together and for a target
/// that is not closed where it has to be: all that can be told before anything is made.
PileSettings pile_settings(const Params& params);

} // namespace scree
