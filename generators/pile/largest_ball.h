// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh.h"
#include "generators/pile/medial_balls.h"

namespace scree {

/// The largest ball inside a closed mesh that is found by climbing from `start`, whose centre is
/// inside: its centre moves wherever the surface is farther, by ever smaller steps.
Ball climb_to_largest(const Mesh& mesh, const Ball& start);

} // namespace scree
