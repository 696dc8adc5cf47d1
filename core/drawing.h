// SPDX-License-Identifier: GPL-3.0-or-later
// SVG drawings that are taken whole, to be shown and to be put into other drawings.
#pragma once

#include "core/math.h"

#include <string>

namespace scree {

/// A drawing that is safe to show anywhere: its root has a viewBox and no size of its own.
struct Drawing {
    std::string markup;
    Vec2 size{0.0}; // that its file gave it [pixels of 1/96 inch]
};

/// Checks an SVG file's bytes. Throws Error naming the line: no valid XML or SVG, scripts, anything
/// from outside the file (only `#id` and embedded PNG and JPEG may be referred to), entities,
/// embedded HTML, rules with @ in style sheets, elements nested more than 200 deep or without a
/// size.
Drawing read_drawing(const std::string& bytes);

/// The drawing as an <svg> element at `place`, in the units of what it is put into. `prefix` goes
/// before all its ids, and its style sheets apply within the element of the id `scope`, which must
/// be around it, so that drawings do not meddle with each other.
std::string embedded_drawing(const std::string& markup, const std::string& prefix,
                             const std::string& scope, const Box2& place);

} // namespace scree
