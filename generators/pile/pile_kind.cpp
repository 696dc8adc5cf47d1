// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_kind.h"

namespace scree {

double unit_radius_of(const Body& body) {
    return body.skin > 0 ? std::sqrt(area(*body.mesh) / pi) / 4 : body.radius / 2;
}

Bodies bodies_of(std::span<const PileKind> kinds) {
    Bodies bodies;
    bodies.reserve(kinds.size());
    for (const PileKind& kind : kinds)
        bodies.push_back(kind.body);
    return bodies;
}

std::vector<double> ranges_of(std::span<const PileKind> kinds) {
    std::vector<double> ranges;
    ranges.reserve(kinds.size());
    for (const PileKind& kind : kinds)
        ranges.push_back(kind.range());
    return ranges;
}

std::uint32_t kind_at(std::span<const PileKind> kinds, double share) {
    double sum = 0;
    for (const PileKind& kind : kinds)
        sum += kind.weight;
    double rest = share * sum;
    std::uint32_t last = 0; // with a weight
    for (std::uint32_t k = 0; k < kinds.size(); ++k) {
        if (!(kinds[k].weight > 0))
            continue;
        last = k;
        if ((rest -= kinds[k].weight) < 0)
            break;
    }
    return last;
}

} // namespace scree
