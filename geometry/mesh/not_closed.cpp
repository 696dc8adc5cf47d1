// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/not_closed.h"

#include <fmt/format.h>

namespace scree {

std::string not_closed(const MeshFacts& facts) {
    return fmt::format("the mesh is not closed: {} boundary edges, {} edges where triangles do not "
                       "meet in twos or disagree on what is outside",
                       facts.boundary_edges, facts.non_manifold_edges);
}

} // namespace scree
