// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree::rocks {

/// What a place does to its rocks, unless parameters say otherwise.
struct Preset {
    const char* name;
    double wear, wear_spread;
    double slope; // [deg]
    double burial;
    double dip;     // [deg]
    double sorting; // [1/m]
};

/// The preset that the parameters name, or the plain one.
const Preset& preset_of(const Params& params);

std::vector<ParamSpec> rocks_specs();

} // namespace scree::rocks
