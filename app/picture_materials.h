// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scenes/reader/scene.h"

#include <vector>

namespace scree {

/// Gives every prototype that is a picture and has the default material a matte one that shows the
/// picture; the new materials are added to the scene's.
void show_pictures(std::vector<Aggregate>& aggregates, Scene& scene);

} // namespace scree
