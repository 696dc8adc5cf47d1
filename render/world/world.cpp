// SPDX-License-Identifier: GPL-3.0-or-later
// The answers to rays.
#include "render/world/world.h"

#include "core/frame.h"
#include "render/world/ticks.h"
#include "render/world/world_state.h"

#include <algorithm>
#include <cassert>

namespace scree {

static_assert(Hit::none == RTC_INVALID_GEOMETRY_ID);

namespace {

float largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Bound of the rounding errors of transforming a ray into an object, intersecting there and
// transforming the hit back, per unit of coordinate: about 30 roundings of 2^-24 (the terms of
// Pharr, Jakob & Humphreys 2016, section 3.9), twice over for safety.
constexpr float rounding = 0x1p-18F;

// `direction` of any length; `length` and the distance of what is met are multiples of it.
RTCRayHit first_hit(RTCScene scene, const Vec3& origin, const Vec3& direction, float length,
                    std::uint64_t* clock) {
    RTCRayHit query;
    query.ray = embree::make_ray(origin, direction, length);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    if (clock != nullptr) {
        const std::uint64_t start = ticks();
        embree::intersect(scene, query);
        *clock += ticks() - start;
    } else {
        embree::intersect(scene, query);
    }
    return query;
}

// The direction in which u grows fastest on a triangle with the sides p and q from its first
// corner, by how the UVs change along them; any along the triangle where none does.
Vec3 tangent(const InstanceRecord& record, const Vec3& p, const Vec3& q, const Vec2f& along_p,
             const Vec2f& along_q, const Vec3& normal) {
    const float turn = std::copysign(1.0F, along_p.x * along_q.y - along_p.y * along_q.x);
    const Vec3 direction = record.direction((p * along_q.y - q * along_p.y) * turn);
    const float square = direction.dot(direction);
    return square > 0 ? direction / std::sqrt(square) : Frame(normal).x;
}

// What a hit on a mesh has beyond its position and normals. Few materials use it and it lies in
// arrays of its own: out of line, so that it takes no registers from all other hits.
[[gnu::noinline]] void fill_uv(const PrototypeRecord& prototype, const InstanceRecord& record,
                               const RawHit& found, Hit& hit) {
    const Mesh& mesh = *prototype.mesh;
    if (mesh.uvs.empty()) {
        hit.tangent = Frame(hit.normal).x;
        return;
    }
    const auto [a, b, c] = mesh.triangles[found.primitive];
    const float u = found.barycentric.x;
    const float v = found.barycentric.y;
    hit.uv = mesh.uvs[a] * (1 - u - v) + mesh.uvs[b] * u + mesh.uvs[c] * v;
    const Vec2f along_p = mesh.uvs[b] - mesh.uvs[a];
    const Vec2f along_q = mesh.uvs[c] - mesh.uvs[a];
    const Vec3 p = mesh.positions[b] - mesh.positions[a];
    const Vec3 q = mesh.positions[c] - mesh.positions[a];
    const float area = p.cross(q).length();
    if (area > 0)
        hit.uv_per_metre =
            std::sqrt(std::abs(along_p.x * along_q.y - along_p.y * along_q.x) / area);
    hit.tangent = tangent(record, p, q, along_p, along_q, hit.normal);
}

} // namespace

void World::State::fill_surface(const RawHit& found, Hit& hit) const {
    const InstanceRecord& record = instances[found.instance];
    const PrototypeRecord& prototype = prototypes[record.prototype];
    const TriangleRecord& triangle = prototype.triangles[found.primitive];
    const auto& [pa, pb, pc] = triangle.positions;
    const float u = found.barycentric.x;
    const float v = found.barycentric.y;
    const float w = 1 - u - v;
    hit.object_position = pa * w + pb * u + pc * v;
    hit.position = record.point(hit.object_position);
    hit.level = hit.position.y + float(origin.y);
    const Vec3 facet = record.normal((pb - pa).cross(pc - pa));
    hit.normal = facet / std::sqrt(facet.dot(facet));
    hit.offset = rounding * (record.scale * std::max({largest(pa), largest(pb), largest(pc)}) +
                             largest(record.rows[3]));
    hit.shading_normal = hit.normal;
    hit.smooth = false;
    if (prototype.has_normals) {
        const auto& [na, nb, nc] = triangle.normals;
        const Vec3 mixed =
            record.normal(unpack_normal(na) * w + unpack_normal(nb) * u + unpack_normal(nc) * v);
        const float square = mixed.dot(mixed);
        // Normals that vanish or point to the other side are of no use.
        if (square > 0 && mixed.dot(hit.normal) > 0) {
            hit.shading_normal = mixed / std::sqrt(square);
            hit.smooth = true;
        }
    }
    hit.record = &record;
    hit.random = record.random;
    hit.instance = found.instance;
    hit.material = prototype.material + (prototype.by_part ? triangle.part : 0);
    hit.light = Hit::none;
    hit.uv = {0.0F, 0.0F};
    hit.uv_per_metre = 0;
    hit.tangent = Vec3(0.0F);
    if (prototype.uses_uv)
        fill_uv(prototype, record, found, hit);
}

RawHit World::find(const Ray& ray, std::uint64_t* clock) const {
    const RTCRayHit query =
        first_hit(state_->scene.get(), ray.origin, ray.direction, ray.length, clock);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return {};
    RawHit raw{query.hit.geomID,
               query.hit.instID[0],
               query.hit.primID,
               {query.hit.u, query.hit.v},
               query.ray.tfar};
    if (raw.instance != Hit::none)
        __builtin_prefetch(&state_->instances[raw.instance]);
    return raw;
}

std::optional<RawHit> World::find_within(std::uint32_t instance, const Ray& ray,
                                         std::uint64_t* clock) const {
    const InstanceRecord& record = state_->instances[instance];
    const ShapeTree* tree = state_->prototypes[record.prototype].tree;
    assert(tree != nullptr);
    const Vec3 origin = record.inverse_direction(ray.origin - record.rows[3]);
    if (!tree->bounds.intersects(origin))
        return std::nullopt;
    const RTCRayHit query = first_hit(tree->scene.get(), origin,
                                      record.inverse_direction(ray.direction), ray.length, clock);
    RawHit raw;
    if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID)
        raw = {query.hit.geomID,
               instance,
               query.hit.primID,
               {query.hit.u, query.hit.v},
               query.ray.tfar};
    return raw;
}

void World::prefetch(const RawHit& raw) const {
    if (!raw.found() || raw.instance == Hit::none)
        return;
    const InstanceRecord& record = state_->instances[raw.instance];
    const PrototypeRecord& prototype = state_->prototypes[record.prototype];
    if (prototype.strands != nullptr && raw.geometry == StrandTree::segments_id)
        prototype.strands->prefetch(raw.primitive);
    else if (prototype.strands == nullptr)
        __builtin_prefetch(&prototype.triangles[raw.primitive]);
}

void World::fill(const Ray& ray, const RawHit& raw, Hit& hit) const {
    assert(raw.found());
    if (raw.instance == Hit::none) {
        state_->fill_light(raw, hit);
        hit.position = ray.origin + ray.direction * raw.distance;
        hit.offset = rounding * largest(hit.position);
    } else {
        const InstanceRecord& record = state_->instances[raw.instance];
        if (state_->prototypes[record.prototype].strands != nullptr)
            state_->fill_strand(ray, raw, hit);
        else
            state_->fill_surface(raw, hit);
    }
    hit.distance = raw.distance;
}

bool World::hit(const Ray& ray, Hit& hit, std::uint64_t* clock) const {
    const RawHit raw = find(ray, clock);
    if (raw.found())
        fill(ray, raw, hit);
    return raw.found();
}

bool World::occluded(const Ray& ray, std::uint64_t* clock) const {
    RTCRay query = embree::make_ray(ray.origin, ray.direction, ray.length);
    if (clock != nullptr) {
        const std::uint64_t start = ticks();
        embree::occluded(state_->scene.get(), query);
        *clock += ticks() - start;
    } else {
        embree::occluded(state_->scene.get(), query);
    }
    return query.tfar < 0; // Embree's sign of a hit
}

Box3 World::bounds() const { return embree::bounds(state_->scene.get()); }

std::size_t World::instance_count() const { return state_->instances.size(); }
std::size_t World::triangle_count() const { return state_->triangles; }
const StrandFigures& World::strand_figures() const { return state_->strand_figures; }
std::span<const std::shared_ptr<const Material>> World::materials() const {
    return state_->materials;
}
std::span<const Light> World::lights() const { return state_->lights; }
const WideVec3& World::origin() const { return state_->origin; }

std::size_t World::State::record_bytes() const {
    std::size_t sum = instances.capacity() * sizeof(InstanceRecord);
    for (const auto& [mesh, tree] : mesh_trees)
        sum += tree.triangles.size() * sizeof(TriangleRecord);
    for (const auto& [strands_of, tree] : strand_trees)
        sum += tree.own_bytes();
    return sum;
}

std::size_t World::memory_bytes() const {
    return static_cast<std::size_t>(state_->bytes) + state_->record_bytes();
}
std::size_t World::peak_bytes() const {
    return static_cast<std::size_t>(state_->peak_bytes) + state_->record_bytes();
}

} // namespace scree
