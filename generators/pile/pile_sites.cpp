// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_sites.h"

#include "core/parallel.h"
#include "core/random.h"
#include "generators/sampling/surface_disks.h"

#include <algorithm>
#include <numeric>

namespace scree {

namespace {

/// Random numbers of one kind in one pass.
struct Stream {
    std::uint64_t seed;
    std::uint64_t part; // of the indices

    Random at(Purpose purpose, std::uint64_t i) const { return {seed, purpose, part << 32 | i}; }
};

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

// u along the surface's level line, v along the normal.
Imath::M33f frame_at(const Vec3& normal, PileFrame frame) {
    if (frame == PileFrame::global)
        return {};
    Vec3 u = Vec3(0, 1, 0).cross(normal);
    u = u.length() > 1e-4F ? u.normalized() : Vec3(1, 0, 0);
    const Vec3 w = u.cross(normal).normalized();
    return {u.x, u.y, u.z, normal.x, normal.y, normal.z, w.x, w.y, w.z};
}

// About v first, so that u and w tilt what lies any way round.
Imath::M33f random_turn(const Vec3& rotation, Random random) {
    Imath::M33f turn;
    for (const int axis : {1, 0, 2}) {
        const double half = double(rotation[axis]) / 2;
        turn = turn * turn_about(axis, random.uniform(-half, half));
    }
    return turn;
}

} // namespace

std::vector<PileSite> pile_sites(const Mesh& target, std::span<const PileKind> kinds,
                                 PileFrame frame, std::uint64_t seed, std::uint32_t pass,
                                 const Context& context) {
    std::vector<PileSite> sites;
    std::vector<double> turns; // when each is tried
    for (std::uint32_t k = 0; k < kinds.size(); ++k) {
        const Stream stream{seed, std::uint64_t{pass} * kinds.size() + k};
        const SurfaceDiskProblem problem{.mesh = &target,
                                         .distances = {2 * kinds[k].distribution_radius()},
                                         .seed = seed ^ stream.part * 0x9e3779b97f4a7c15ULL};
        const SurfaceDiskSet set = sample_surface_disks(problem, context);
        const std::size_t first = sites.size();
        sites.resize(first + set.samples.size());
        parallel_for(set.samples.size(), 256, [&](std::size_t i) {
            const SurfaceSample& sample = set.samples[i];
            const Vec3 normal = smooth_normal(target, sample);
            sites[first + i] = {
                .position = sample.position,
                .normal = normal,
                .world_from_component =
                    random_turn(kinds[k].rotation, stream.at(Purpose::pile_turn, i)) *
                    frame_at(normal, frame),
                .kind = k};
        });
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < set.samples.size(); ++i)
            order.emplace_back(stream.at(Purpose::pile_order, i).uniform(), i);
        std::sort(order.begin(), order.end());
        turns.resize(sites.size());
        for (std::size_t rank = 0; rank < order.size(); ++rank)
            turns[first + order[rank].second] =
                (double(rank) + order[rank].first) / kinds[k].weight;
    }
    std::vector<std::size_t> order(sites.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(turns[a], a) < std::pair(turns[b], b);
    });
    std::vector<PileSite> ordered;
    ordered.reserve(sites.size());
    for (const std::size_t i : order)
        ordered.push_back(sites[i]);
    return ordered;
}

} // namespace scree
