// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/neighbour_hash.h"

namespace scree {

NeighbourHash::NeighbourHash(std::span<const PileKind> kinds) : kinds_(kinds.size()) {
    for (std::size_t k = 0; k < kinds.size(); ++k)
        kinds_[k].reach = kinds[k].component.reach;
}

void NeighbourHash::add(std::uint32_t kind, std::uint32_t index, const Imath::V3d& centre) {
    Cells& cells = kinds_[kind];
    cells.entries[{cells.cell(centre.x), cells.cell(centre.y), cells.cell(centre.z)}].push_back(
        {centre, index});
}

} // namespace scree
