// SPDX-License-Identifier: GPL-3.0-or-later
// How opaque colours are: their hue does not matter for a region.
#pragma once

#include <optional>
#include <string_view>

namespace scree {

/// The alpha of a colour of CSS (Color 4) between 0 and 1, or none for currentColor: names, #rgb,
/// #rgba, #rrggbb, #rrggbbaa, transparent, rgb(), rgba(), hsl(), hsla(), hwb(), lab(), lch(),
/// oklab(), oklch(), color() and light-dark(), whose first colour it takes. Throws Error for what
/// is no colour.
std::optional<double> css_alpha(std::string_view color);

/// An opacity, as a number or in per cent, brought to 0 to 1. Throws Error for anything else.
double css_opacity(std::string_view text);

} // namespace scree
