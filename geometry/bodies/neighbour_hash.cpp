// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/neighbour_hash.h"

namespace scree {

NeighbourHash::NeighbourHash(const Bodies& bodies) : cells_of_body_(bodies.size()) {
    for (std::size_t k = 0; k < bodies.size(); ++k)
        cells_of_body_[k].reach = bodies[k]->reach;
}

void NeighbourHash::add(std::uint32_t body, std::uint32_t index, const Imath::V3d& centre) {
    Cells& cells = cells_of_body_[body];
    cells.entries[{cells.cell(centre.x), cells.cell(centre.y), cells.cell(centre.z)}].push_back(
        {centre, index});
}

} // namespace scree
