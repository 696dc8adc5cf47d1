// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/overlap_measure.h"

#include "core/parallel.h"
#include "core/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scree {

namespace {

// Points evenly at random inside of a body; fewer if it fills next to nothing of its box.
std::vector<Vec3> points_inside(const Body& body, std::size_t count, Random random) {
    Box3 box;
    for (const Vec3& p : body.mesh->positions)
        box.extendBy(p - body.origin);
    const Vec3 size = box.size();
    std::vector<Vec3> points;
    for (std::size_t trial = 0; points.size() < count && trial < 1000 * count; ++trial) {
        Vec3 p = box.min;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] += size[axis] * random.uniform_float();
        if (body.distance.at(p) < 0)
            points.push_back(p);
    }
    return points;
}

/// How much one body overlaps the others.
struct Overlap {
    double depth = 0; // the deepest, in radii of the smaller of the two
    double share = 0; // of its volume that is inside of others
};

Overlap overlap_of(const PlacedBodies& bodies, std::uint32_t i, const std::vector<Vec3>& inside) {
    const PlacedBody& placed = bodies.all[i];
    const Body& own = bodies.body(placed);
    Overlap overlap;
    std::vector<char> taken(inside.size(), 0);
    bodies.hash.near(placed.pose.centre, own.reach, [&](std::uint32_t j) {
        if (j == i)
            return;
        const Body& other = bodies.body(bodies.all[j]);
        const RelativePose there = relative(placed.pose, bodies.all[j].pose);
        if (double(other.distance.at(there.offset)) > own.reach)
            return;
        const RelativePose back = relative(bodies.all[j].pose, placed.pose);
        const float depth = std::max(own.samples.depth_in(other.distance, there, 0),
                                     other.samples.depth_in(own.distance, back, 0));
        overlap.depth = std::max(overlap.depth, double(depth) / std::min(own.radius, other.radius));
        for (std::size_t p = 0; p < inside.size(); ++p)
            if (!taken[p] && other.distance.at(there(inside[p])) < 0)
                taken[p] = 1;
    });
    if (!inside.empty())
        overlap.share = double(std::count(taken.begin(), taken.end(), 1)) / double(inside.size());
    return overlap;
}

} // namespace

OverlapMeasure measure_overlap(const PlacedBodies& bodies, std::size_t most,
                               std::size_t volume_samples) {
    std::vector<std::vector<Vec3>> inside;
    for (std::size_t k = 0; k < bodies.shapes.size(); ++k)
        inside.push_back(
            points_inside(*bodies.shapes[k], volume_samples, Random(0, Purpose::pile_inside, k)));
    const std::size_t count = std::min(most, bodies.all.size());
    std::vector<Overlap> overlaps(count);
    parallel_for(count, 4, [&](std::size_t n) {
        const auto i = static_cast<std::uint32_t>(n * bodies.all.size() / count);
        overlaps[n] = overlap_of(bodies, i, inside[bodies.all[i].body]);
    });
    OverlapMeasure measure{.measured = count};
    if (count == 0)
        return measure;
    std::vector<double> depths;
    for (const Overlap& overlap : overlaps) {
        depths.push_back(overlap.depth);
        measure.volume_share += overlap.share / double(count);
    }
    std::sort(depths.begin(), depths.end());
    measure.mean_depth = std::accumulate(depths.begin(), depths.end(), 0.0) / double(count);
    measure.percentile_99 = depths[static_cast<std::size_t>(std::ceil(0.99 * double(count))) - 1];
    measure.largest_depth = depths.back();
    return measure;
}

} // namespace scree
