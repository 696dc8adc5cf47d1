// SPDX-License-Identifier: GPL-3.0-or-later
// Plain values against their declarations: numbers, texts, vectors, colours, ranges.
#pragma once

#include "core/params.h"
#include "scenes/reader/description.h"
#include "scenes/reader/mistakes.h"

namespace scree {

/// A value with what messages about it need.
struct Given {
    const Description& value;
    Location where;   // of the field
    std::string path; // "generator.rocks.radius"
};

/// Whether a number in the unit of scripts keeps the declared limits.
bool in_range(double number, const ParamSpec& spec);

/// The value in the program's units, or monostate after noting what is wrong with it. For the types
/// that stand for themselves, not for meshes, records and the like.
Value check_value(const Given& given, const ParamSpec& spec, Mistakes& mistakes);

} // namespace scree
