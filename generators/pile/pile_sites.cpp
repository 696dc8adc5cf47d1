// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_sites.h"

#include "core/parallel.h"
#include "core/random.h"
#include "geometry/sampling/surface_disks.h"

#include <algorithm>

namespace scree {

namespace {

Imath::M33f turn_about(int axis, double angle) {
    const auto c = static_cast<float>(std::cos(angle));
    const auto s = static_cast<float>(std::sin(angle));
    const int j = (axis + 1) % 3;
    const int k = (axis + 2) % 3;
    Imath::M33f m;
    m[j][j] = c;
    m[j][k] = s;
    m[k][j] = -s;
    m[k][k] = c;
    return m;
}

// Rows: u along the flow or the surface's level line, v along the normal, w across.
Imath::M33f frame_at(const Imath::V3d& position, const Vec3& normal, const PileTurns& turns) {
    if (turns.flow == nullptr && turns.frame == PileFrame::global)
        return {};
    const Vec3 u =
        turns.flow != nullptr ? turns.flow->tangent(position, normal) : level_line(normal);
    const Vec3 w = u.cross(normal).normalized();
    return {u.x, u.y, u.z, normal.x, normal.y, normal.z, w.x, w.y, w.z};
}

// About v first: the rotations about u and w then tilt the component whichever way it points.
Imath::M33f random_turn(const Vec3& rotation, Random random) {
    Imath::M33f turn;
    for (const int axis : {1, 0, 2}) {
        const double half = double(rotation[axis]) / 2;
        turn = turn * turn_about(axis, random.uniform(-half, half));
    }
    return turn;
}

double mean_distribution_radius(std::span<const PileKind> shapes) {
    double sum = 0;
    for (const PileKind& shape : shapes)
        sum += shape.distribution_radius();
    return sum / double(shapes.size());
}

} // namespace

BodySite PileTurns::site(const Imath::V3d& position, const Vec3& normal, std::uint32_t kind,
                         std::uint64_t number) const {
    if (kinds[kind].shapes > 1)
        kind += Random(seed, Purpose::pile_choice, number).below(kinds[kind].shapes);
    return {.position = position,
            .normal = normal,
            .world_from_body =
                random_turn(kinds[kind].rotation, Random(seed, Purpose::pile_turn, number)) *
                frame_at(position, normal, *this),
            .body = kind};
}

std::vector<BodySite> pile_sites(const Mesh& target, const PileTurns& turns,
                                 const Context& context) {
    struct Tried {
        double when;
        BodySite site;
    };
    std::vector<Tried> tried;
    for (std::uint32_t k = 0; k < turns.kinds.size(); ++k) {
        const PileKind& kind = turns.kinds[k];
        if (kind.shapes == 0)
            continue;
        const auto number = [k](std::size_t i) { return std::uint64_t{k} << 32 | i; };
        const SurfaceDiskSet set = sample_surface_disks(
            {.mesh = &target,
             .distances = {2 * mean_distribution_radius(turns.kinds.subspan(k, kind.shapes))},
             .seed = derived_seed(turns.seed, Purpose::pile_sites, k)},
            context);
        std::vector<std::pair<double, std::size_t>> order(set.samples.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = {Random(turns.seed, Purpose::pile_order, number(i)).uniform(), i};
        std::sort(order.begin(), order.end());
        const std::size_t first = tried.size();
        tried.resize(first + order.size());
        parallel_for(order.size(), 256, [&](std::size_t rank) {
            const auto [share, i] = order[rank];
            const SurfaceSample& sample = set.samples[i];
            tried[first + rank] = {
                (double(rank) + share) / kind.weight,
                turns.site(sample.position, smooth_normal(target, sample), k, number(i))};
        });
    }
    std::stable_sort(tried.begin(), tried.end(),
                     [](const Tried& a, const Tried& b) { return a.when < b.when; });
    std::vector<BodySite> sites;
    sites.reserve(tried.size());
    for (const Tried& one : tried)
        sites.push_back(one.site);
    return sites;
}

} // namespace scree
