// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_cover.h"

#include "core/parallel.h"
#include "core/random.h"
#include "core/warps.h"
#include "geometry/mesh/mesh_rays.h"
#include "geometry/plane/field.h"
#include "geometry/sampling/surface_disks.h"

#include <algorithm>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

Vec3 cosine_direction(const Vec3& normal, Random& random) {
    // A point of the unit sphere about the tip of the normal.
    const double u = random.uniform();
    const Vec3 d = normal + Vec3(warp::sphere(Vec2(u, random.uniform())));
    return d.length() > 1e-3F ? d.normalized() : normal;
}

/// Draws random points of a mesh, even by area.
class AreaSampler {
  public:
    explicit AreaSampler(const Mesh& mesh) : mesh_(&mesh) {
        for (const Mesh::Triangle& t : mesh.triangles) {
            const Vec3 n = normal_of(t);
            sums_.push_back((sums_.empty() ? 0 : sums_.back()) + double(n.length()));
        }
    }

    SurfaceSample at(Random& random) const {
        const auto found =
            std::upper_bound(sums_.begin(), sums_.end(), random.uniform(0, sums_.back()));
        const auto t = std::min<std::size_t>(std::size_t(found - sums_.begin()), sums_.size() - 1);
        const Mesh::Triangle& v = mesh_->triangles[t];
        const double u = random.uniform();
        const Vec3d b = warp::triangle(Vec2(u, random.uniform()));
        const Vec3d p = Vec3d(mesh_->positions[v[0]]) * b.x + Vec3d(mesh_->positions[v[1]]) * b.y +
                        Vec3d(mesh_->positions[v[2]]) * b.z;
        return {p, normal_of(v).normalized(), static_cast<std::uint32_t>(t), 0};
    }

  private:
    Vec3 normal_of(const Mesh::Triangle& t) const {
        const Vec3& a = mesh_->positions[t[0]];
        return (mesh_->positions[t[1]] - a).cross(mesh_->positions[t[2]] - a);
    }

    const Mesh* mesh_;
    std::vector<double> sums_;
};

// The distances along the ray, from 0 on, at which it is within `radius` of the point.
Range within(const OutsideRay& ray, const Vec3d& point, double radius) {
    const Vec3d to = point - ray.origin;
    const double along = to.dot(Vec3d(ray.direction));
    const double half2 = radius * radius - (to.length2() - along * along);
    if (half2 <= 0)
        return {0, -1};
    const double half = std::sqrt(half2);
    return {std::max(0.0, along - half), along + half};
}

// Sphere tracing (Hart 1996): a step as long as the distance to the body meets nothing.
bool meets(const OutsideRay& ray, const Body& body, const Pose& pose) {
    const Range range = within(ray, pose.centre, body.reach);
    const Imath::M33f inverse = pose.world_from_body.transposed();
    const Vec3 origin = Vec3(ray.origin - pose.centre) * inverse;
    const Vec3 direction = ray.direction * inverse;
    const double least = 0.01 * body.radius;
    for (double t = range.low; t <= range.high;) {
        const auto distance = double(body.distance.at(origin + direction * static_cast<float>(t)));
        if (distance <= 0)
            return true;
        t += std::max(distance, least);
    }
    return false;
}

Imath::Box3d bounds_of(const PlacedBodies& pile) {
    Imath::Box3d box;
    for (const PlacedBody& placed : pile.all) {
        const Vec3d reach(pile.body(placed).reach);
        box.extendBy(placed.pose.centre - reach);
        box.extendBy(placed.pose.centre + reach);
    }
    return box;
}

// Whether the ray, its origin included, meets a component inside of the box.
bool is_hidden(const PlacedBodies& pile, const OutsideRay& ray, const Imath::Box3d& bounds) {
    const double piece = 4 * largest_reach(pile.shapes);
    Vec3d at = ray.origin;
    bool hidden = false;
    while (!hidden && bounds.intersects(at)) {
        const Vec3d next = at + Vec3d(ray.direction) * piece;
        pile.hash.near((at + next) * 0.5, piece / 2, [&](std::uint32_t index) {
            const PlacedBody& placed = pile.all[index];
            hidden = hidden || meets(ray, pile.body(placed), placed.pose);
        });
        at = next;
    }
    return hidden;
}

} // namespace

std::vector<OutsideRay> outside_rays(const Mesh& target, std::size_t count, std::uint64_t seed,
                                     std::uint32_t stream) {
    const AreaSampler sampler(target);
    const MeshRays blocked(target);
    const double near = 1e-4 * double(bounds(target).size().length());
    const bool closed = inspect(target).closed();
    std::vector<OutsideRay> rays(count);
    std::vector<char> leaves(count, 0);
    parallel_for(count, 64, [&](std::size_t i) {
        Random random(seed, Purpose::pile_ray, std::uint64_t{stream} << 32 | i);
        const SurfaceSample sample = sampler.at(random);
        const float side = closed || random.uniform() < 0.5 ? 1.0F : -1.0F;
        rays[i] = {sample.position, smooth_normal(target, sample),
                   cosine_direction(sample.normal * side, random)};
        leaves[i] = !blocked.hits(rays[i].origin, rays[i].direction, near);
    });
    std::vector<OutsideRay> out;
    for (std::size_t i = 0; i < count; ++i)
        if (leaves[i])
            out.push_back(rays[i]);
    return out;
}

std::vector<OutsideRay> open_rays(const PlacedBodies& pile, const std::vector<OutsideRay>& rays) {
    Imath::Box3d box = bounds_of(pile);
    for (const OutsideRay& ray : rays)
        box.extendBy(ray.origin);
    std::vector<char> hidden(rays.size(), 0);
    parallel_for(rays.size(), 16,
                 [&](std::size_t i) { hidden[i] = is_hidden(pile, rays[i], box); });
    std::vector<OutsideRay> open;
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (!hidden[i])
            open.push_back(rays[i]);
    return open;
}

} // namespace scree
