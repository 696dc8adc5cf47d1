// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/not_closed.h"

#include "core/text.h"

#include <fmt/format.h>

namespace scree {

std::string not_closed(const MeshFacts& facts) {
    return fmt::format("the mesh is not closed: {}, {} where triangles do not meet in twos or "
                       "disagree on what is outside",
                       counted(facts.boundary_edges, "boundary edge"),
                       counted(facts.non_manifold_edges, "edge"));
}

} // namespace scree
