// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/nearest_surface.h"

#include "geometry/mesh/triangle_corners.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace scree {

namespace {

constexpr std::uint32_t leaf_size = 4;

Vec3 middle_of(const Mesh& mesh, std::uint32_t triangle) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    return (a + b + c) / 3.0F;
}

float distance2(const Box3& box, const Vec3& p) {
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float beyond = std::max({box.min[axis] - p[axis], p[axis] - box.max[axis], 0.0F});
        sum += beyond * beyond;
    }
    return sum;
}

} // namespace

NearestSurface::NearestSurface(const Mesh& mesh) : mesh_(&mesh), order_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    nodes_.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(order_.size()));
    triangles_.reserve(order_.size());
    for (const std::uint32_t t : order_)
        triangles_.emplace_back(corners_of(mesh, t));
}

void NearestSurface::split(std::uint32_t node, std::uint32_t first, std::uint32_t end) {
    Box3 middles;
    for (std::uint32_t i = first; i < end; ++i) {
        for (const Vec3& corner : corners_of(*mesh_, order_[i]))
            nodes_[node].box.extendBy(corner);
        middles.extendBy(middle_of(*mesh_, order_[i]));
    }
    if (end - first <= leaf_size) {
        nodes_[node].first = first;
        nodes_[node].count = end - first;
        return;
    }
    const auto axis = static_cast<int>(middles.majorAxis());
    const std::uint32_t half = first + (end - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         return std::pair(middle_of(*mesh_, a)[axis], a) <
                                std::pair(middle_of(*mesh_, b)[axis], b);
                     });
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].first = children;
    nodes_.resize(nodes_.size() + 2);
    split(children, first, half);
    split(children + 1, half, end);
}

NearestSurface::Point NearestSurface::point_on(std::uint32_t triangle, const Imath::V3d& p,
                                               const Vec3& at) const {
    const auto [a, b, c] = corners_of(*mesh_, triangle);
    const Imath::V3d position(at);
    const Vec3 facet = (b - a).cross(c - a).normalized();
    return {position, smooth_normal(*mesh_, triangle, position, facet), (p - position).length(),
            triangle};
}

NearestSurface::Point NearestSurface::nearest(const Imath::V3d& p) const {
    return *nearest_within(p, std::numeric_limits<float>::infinity());
}

std::optional<NearestSurface::Point> NearestSurface::nearest_within(const Imath::V3d& p,
                                                                    float most) const {
    const Vec3 from(p);
    struct Open {
        std::uint32_t node;
        float bound;
    };
    std::array<Open, 64> open; // one a level, and the tree is balanced
    std::size_t count = 0;
    open[count++] = {0, distance2(nodes_[0].box, from)};
    float least = most * most;
    std::optional<std::uint32_t> triangle;
    Vec3 at;
    while (count > 0) {
        const Open next = open[--count];
        if (next.bound >= least)
            continue;
        const Node& node = nodes_[next.node];
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Vec3 q = triangles_[i].nearest(from);
            if ((q - from).length2() < least) {
                least = (q - from).length2();
                triangle = order_[i];
                at = q;
            }
        }
        if (node.count > 0)
            continue;
        Open near{node.first, distance2(nodes_[node.first].box, from)};
        Open far{node.first + 1, distance2(nodes_[node.first + 1].box, from)};
        if (near.bound > far.bound)
            std::swap(near, far);
        open[count++] = far;
        open[count++] = near;
    }
    if (!triangle)
        return {};
    return point_on(*triangle, p, at);
}

} // namespace scree
