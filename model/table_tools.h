// SPDX-License-Identifier: GPL-3.0-or-later
// Declarations that several of the tables share.
#pragma once

#include "core/params.h"

namespace scree {

/// For check_color: light may have this radiance at most; a reflectance, 1.
inline constexpr float any_radiance = 1e9F;

ParamSpec strength_spec(double fallback, std::string doc, std::string unit);
ParamSpec color_spec(std::string name, std::string doc); // white by default

/// Throws the parameter's Error unless every channel is from 0 to `max`.
void check_color(const Params& params, const std::string& name, const Color& color, float max);

/// A number parameter as the renderer's float.
float float_number(const Params& params, const std::string& name);

} // namespace scree
