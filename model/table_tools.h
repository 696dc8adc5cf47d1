// SPDX-License-Identifier: GPL-3.0-or-later
// Declarations that several tables of the model share.
#pragma once

#include "core/params.h"
#include "model/material.h"

namespace scree {

/// The upper limit of radiance, for check_color; that of a reflectance is 1.
inline constexpr float max_radiance = 1e9F;

ParamSpec strength_spec(double fallback, std::string doc, std::string unit);
ParamSpec color_spec(std::string name, std::string doc); // white by default

/// The parameters `color` and `palette` of a material, and what they say. Throws the parameter's
/// Error for a reflectance out of range.
ParamSpec paint_spec(const Color& fallback, std::string doc);
ParamSpec palette_spec();
Paint make_paint(const Params& params);

/// Throws the parameter's Error unless every channel is from 0 to `max`.
void check_color(const Params& params, const std::string& name, const Color& color, float max);

/// A number parameter, rounded to float.
float float_number(const Params& params, const std::string& name);

} // namespace scree
