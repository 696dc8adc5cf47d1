// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.h"

#include <string>

namespace scree {

/// The number of the item of scene.objects that --object names, counted from 1: an item's name or
/// number. Throws Error (usage) when there is none, or several have the name.
int chosen_object(const std::string& given, const std::string& scene, const SceneDraft& draft);

/// Leaves the other items unmade: nothing stands in their place.
void make_only(int object, SceneDraft& draft);

} // namespace scree
