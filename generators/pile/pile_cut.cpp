// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_cut.h"

namespace scree {

PlacedBodies cut_open(const PlacedBodies& pile, const CutPlane& plane) {
    PlacedBodies kept(pile.shapes);
    for (const PlacedBody& placed : pile.all)
        if ((placed.pose.centre - plane.point).dot(plane.normal) <= 0)
            kept.add(placed);
    return kept;
}

} // namespace scree
