// SPDX-License-Identifier: GPL-3.0-or-later
// Checks plain values against their declarations: numbers, texts, vectors, colours, ranges.
#pragma once

#include "core/params.h"
#include "scenes/reader/description.h"
#include "scenes/reader/mistakes.h"

namespace scree {

/// A value with its location and path, for error messages.
struct Given {
    const Description& value;
    Location where;   // of the field
    std::string path; // "generator.rocks.radius"
};

/// Whether a number in the unit of scripts lies within the declared limits.
bool in_range(double number, const ParamSpec& spec);

/// The value in the program's units, or monostate after reporting an error. For plain types only,
/// not for objects, records and lists of records.
Value check_value(const Given& given, const ParamSpec& spec, Mistakes& mistakes);

} // namespace scree
