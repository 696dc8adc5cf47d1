// SPDX-License-Identifier: GPL-3.0-or-later
// What a hit on a strand says.
#include "render/world/world_state.h"

#include <algorithm>

namespace scree {

namespace {

// How far rays leave from a strand's surface, in radii: so far that no outward ray meets its own
// segment again by the rounding of Embree's intersection.
constexpr float offset_radii = 0.01F;

// Bound of the rounding errors of taking a point of a strand to the world, per unit of coordinate:
// 4 roundings of 2^-24, twice over for safety. (That of meshes, 2^-18, is often more than a fibre's
// radius.)
constexpr float rounding = 0x1p-21F;

float largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Where along the strand and across its width, as seen along `direction` in the object's frame.
void fill_uv(const StrandTree& tree, const StrandPoint& point, std::uint32_t first,
             std::size_t strand, const Vec3& direction, Hit& hit) {
    const std::uint32_t begin = tree.strands->offsets[strand];
    const auto segments = static_cast<float>(tree.strands->offsets[strand + 1] - begin + 1 -
                                             tree.strands->piece_points());
    const Vec3 right = direction.cross(point.axis);
    const float square = right.dot(right);
    const float across = square > 0 ? point.normal.dot(right) / std::sqrt(square) : 0;
    hit.uv = {(static_cast<float>(first - begin) + point.fraction) / segments,
              0.5F + 0.5F * across};
    const float area = 2 * point.radius * segments * point.segment_length;
    hit.uv_per_metre = area > 0 ? 1 / std::sqrt(area) : 0;
}

// The cap of a chain of cones that stands for a spline, where `near` is beyond the spline's end.
std::optional<StrandCap> cap_at(const StrandTree& tree, std::uint32_t segment, float along,
                                std::size_t strand, const Vec3& near) {
    const bool tip = along >= 0.5F;
    const std::vector<std::uint32_t>& offsets = tree.strands->offsets;
    const std::uint32_t end_piece = tip ? offsets[strand + 1] - 4 : offsets[strand];
    if (tree.chords.empty() || tree.is_fibre || tree.firsts[segment] != end_piece)
        return std::nullopt;
    const std::optional<StrandCap> cap = end_cap(tree, segment, tip ? 1.0F : 0.0F);
    return cap && (near - cap->centre).dot(cap->outwards) > 0 ? cap : std::nullopt;
}

} // namespace

void World::State::fill_strand(const Ray& ray, const RawHit& found, Hit& hit) const {
    const InstanceRecord& record = instances[found.instance];
    const PrototypeRecord& prototype = prototypes[record.prototype];
    const StrandTree& tree = *prototype.strands;
    const bool on_cap = found.geometry == StrandTree::caps_id;
    const auto [segment, along] = on_cap ? std::pair(tree.caps[found.primitive].segment, 0.0F)
                                         : tree.segment_at(found.primitive, found.barycentric.x);
    const std::uint32_t first = tree.firsts[segment];
    const std::size_t strand = strand_of(*tree.strands, first);
    const Vec3 direction = record.inverse_direction(ray.direction);
    const Vec3 from = record.inverse_direction(ray.origin - record.rows[3]);
    const Vec3 near = from + direction * found.distance;
    const std::optional<StrandCap> cap =
        on_cap ? tree.caps[found.primitive] : cap_at(tree, segment, along, strand, near);
    const StrandPoint point =
        cap ? onto_cap(tree, *cap, near) : onto_segment(tree, segment, near, along);
    hit.object_position = point.position;
    hit.position = record.point(point.position);
    hit.level = hit.position.y + float(origin.y);
    const Vec3 normal = record.normal(point.normal);
    hit.normal = hit.shading_normal = normal / std::sqrt(normal.dot(normal));
    hit.smooth = false;
    const float off = tree.chords.empty() ? offset_radii : offset_radii + chord_tolerance;
    hit.offset = std::max(off * point.radius * record.scale,
                          rounding * (largest(hit.position) + largest(record.rows[3])));
    hit.random = record.random;
    if (!tree.strands->randoms.empty()) {
        hit.random += tree.strands->randoms[strand];
        hit.random -= std::floor(hit.random);
    }
    hit.record = &record;
    hit.instance = found.instance;
    hit.material = prototype.material;
    hit.light = Hit::none;
    hit.uv = {0.0F, 0.0F};
    hit.uv_per_metre = 0;
    hit.tangent = Vec3(0.0F);
    if (!prototype.uses_uv)
        return;
    const Vec3 axis = record.direction(point.axis);
    hit.tangent = axis / std::sqrt(axis.dot(axis));
    fill_uv(tree, point, first, strand, direction, hit);
}

} // namespace scree
