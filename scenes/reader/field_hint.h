// SPDX-License-Identifier: GPL-3.0-or-later
// What to say of a field that a table does not have.
#pragma once

#include "model/catalog.h"

#include <span>
#include <string>
#include <vector>

namespace scree {

/// A table whose fields are being read. The specs and the family outlive it.
struct OpenTable {
    std::string path;                             // "generator.layout.components[2]"
    const std::vector<ParamSpec>& specs;          // of its fields
    const Registry<MakeObject>* family = nullptr; // of a constructor's table
};

/// For the unknown field `name` of the innermost, last table: that a table around it has such a
/// field, the nearest name, that another constructor of the family has it at this place, and what
/// there is.
std::string field_hint(const std::string& name, std::span<const OpenTable> open);

} // namespace scree
