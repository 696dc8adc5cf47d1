// SPDX-License-Identifier: GPL-3.0-or-later
// SVG drawings kept as documents, to be rasterised and to be embedded in other drawings.
#pragma once

#include "core/math.h"

#include <string>

namespace scree {

/// A drawing that is safe to show anywhere: its root has a viewBox and no size of its own.
struct Drawing {
    std::string markup;
    Vec2 size{0.0}; // as given in its file [pixels of 1/96 inch]
};

/// Parses and checks the bytes of an SVG file. Throws Error naming the line for invalid XML or SVG,
/// scripts, references to anything outside the file (allowed are `#id` and embedded PNG and JPEG),
/// entity declarations, embedded HTML, at-rules in style sheets, elements nested more than 200
/// deep, and a drawing without a size.
Drawing read_drawing(const std::string& bytes);

/// The drawing as an <svg> element at `place`, in the units of the enclosing document. To keep
/// drawings apart, `prefix` is put before all its ids and its style sheets apply only within the
/// element with the id `scope`, which must enclose it.
std::string embedded_drawing(const std::string& markup, const std::string& prefix,
                             const std::string& scope, const Box2& place);

} // namespace scree
