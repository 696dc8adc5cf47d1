// SPDX-License-Identifier: GPL-3.0-or-later
// The small languages in the attributes of an SVG. All throw Error saying what is wrong where;
// numbers are at most 1e9, since coordinates beyond that are mistakes.
#pragma once

#include "core/error.h"
#include "geometry/plane/svg/bezier_path.h"

#include <limits>
#include <string_view>

namespace scree {

/// Runs `read` and puts the attribute's name before what it throws.
template <class Read>
auto named(const std::string& name, const Read& read) {
    try {
        return read();
    } catch (const Error& error) {
        throw Error(name + ": " + error.diagnostics().front().message);
    }
}

/// What a path's `d` says: all commands of SVG 1.1, absolute and relative.
BezierPath parse_path_data(std::string_view data);

/// A `transform`: matrix, translate, scale, rotate, skewX and skewY, the first one outermost.
Affine parse_transform(std::string_view text);

/// Numbers between spaces and commas, as in `points` and `viewBox`.
std::vector<double> parse_numbers(std::string_view text);

/// What relative lengths are relative to [pixels]; not a number where it is not known.
struct LengthBase {
    double whole = std::numeric_limits<double>::quiet_NaN(); // 100%
    double font = std::numeric_limits<double>::quiet_NaN();  // 1em
};

/// A length in pixels of 1/96 inch, from px, mm, cm, Q, in, pt, pc, em, ex, % or no unit.
double parse_length(std::string_view text, const LengthBase& base = {});

} // namespace scree
