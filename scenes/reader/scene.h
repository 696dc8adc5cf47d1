// SPDX-License-Identifier: GPL-3.0-or-later
// description -> scene: every value checked against its declaration, every object made.
#pragma once

#include "model/catalog.h"
#include "model/scene.h"
#include "scenes/reader/description.h"

namespace scree {

/// Checks the whole description, collecting all mistakes into one Error, and makes its objects but
/// for what generators bake. `path` is the script's.
SceneDraft resolve(const DescriptionNode& root, const std::string& path, const Catalog& catalog);

} // namespace scree
