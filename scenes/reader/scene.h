// SPDX-License-Identifier: GPL-3.0-or-later
// From a description to a scene draft.
#pragma once

#include "model/catalog.h"
#include "model/scene.h"
#include "scenes/reader/description.h"

namespace scree {

/// Checks every value of the description against its declaration and makes all objects except those
/// that generators bake. `path` is the script's. Throws one Error with all errors found.
SceneDraft resolve(const DescriptionNode& root, const std::string& path, const Catalog& catalog);

} // namespace scree
