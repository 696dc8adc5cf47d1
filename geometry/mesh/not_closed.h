// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <string>

namespace scree {

/// What to say of a mesh that is not closed: how many of its edges are at fault.
std::string not_closed(const MeshFacts& facts);

} // namespace scree
