// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/world/world.h"

#include "core/error.h"
#include "core/parallel.h"
#include "render/world/embree_adapter.h"
#include "render/world/instance_record.h"
#include "render/world/ticks.h"
#include "render/world/triangle_record.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <map>
#include <mutex>
#include <vector>

namespace scree {

namespace {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using DeviceHandle = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using SceneHandle = std::unique_ptr<RTCSceneTy, ReleaseScene>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

// What instances of one mesh share.
struct SharedMesh {
    SceneHandle tree;
    std::vector<TriangleRecord> triangles;
    Box3 bounds; // in the object's frame
};

struct PrototypeRecord {
    const Mesh* mesh;
    const TriangleRecord* triangles;
    std::uint32_t material;
    bool has_normals;
    const SharedMesh* shared; // null where there is nothing to see
};

float largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Bound of the rounding errors of transforming a ray into an object, intersecting there and
// transforming the hit back, per unit of coordinate: about 30 roundings of 2^-24 (the terms of
// Pharr, Jakob & Humphreys 2016, section 3.9), twice over for safety.
constexpr float rounding = 0x1p-18F;

/// Null where there is nothing to see.
const Mesh* mesh_to_draw(const Aggregate& aggregate, const Prototype& prototype) {
    if (prototype.strands() != nullptr)
        throw Error(Diagnostic{aggregate.where, aggregate.generator,
                               prototype.name + " is of strands, which cannot be rendered yet",
                               ""});
    return prototype.mesh();
}

Box3 bounds_of(RTCScene scene) {
    RTCBounds box{};
    rtcGetSceneBounds(scene, &box);
    if (!(box.lower_x <= box.upper_x))
        return {};
    return {{box.lower_x, box.lower_y, box.lower_z}, {box.upper_x, box.upper_y, box.upper_z}};
}

// `direction` of any length; `length` and the distance of what is met count in lengths of it.
RTCRayHit first_hit(RTCScene scene, const Vec3& origin, const Vec3& direction, float length,
                    std::uint64_t* clock) {
    RTCRayHit query;
    query.ray.org_x = origin.x;
    query.ray.org_y = origin.y;
    query.ray.org_z = origin.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    query.ray.tnear = 0;
    query.ray.tfar = length;
    query.ray.time = 0;
    query.ray.mask = 0xffffffffU;
    query.ray.id = 0;
    query.ray.flags = 0;
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

} // namespace

static_assert(Hit::none == RTC_INVALID_GEOMETRY_ID);

struct World::State {
    std::atomic<std::int64_t> bytes = 0;
    std::mutex error_mutex;
    std::string error;
    DeviceHandle device;
    std::map<const Mesh*, SharedMesh> shared;
    std::vector<std::shared_ptr<const Mesh>> meshes;
    std::vector<PrototypeRecord> prototypes;
    std::vector<InstanceRecord> instances;
    std::vector<std::uint32_t> light_of_quad;
    std::vector<Vec3> light_vertices;
    SceneHandle scene;
    std::size_t triangles = 0;
    std::vector<std::shared_ptr<const Material>> materials; // the one without a name first
    std::vector<Light> lights;

    void check() {
        const std::lock_guard lock(error_mutex);
        if (!error.empty())
            throw Error::resource("cannot build the scene for rendering: " + error);
    }
    SceneHandle new_scene() const {
        SceneHandle handle(rtcNewScene(device.get()));
        rtcSetSceneFlags(handle.get(), RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(handle.get(), RTC_BUILD_QUALITY_MEDIUM);
        return handle;
    }
    void open_device();
    SceneHandle tree(const Mesh& mesh) const;
    SharedMesh shared_mesh(const Mesh& mesh) const;
    void add_prototypes(std::span<const Aggregate> aggregates, const Context& context);
    void add_instances(std::span<const Aggregate> aggregates);
    void add_lights();
    void commit(const Context& context);
    void fill_surface(const RawHit& found, Hit& hit) const;
    void fill_light(const RawHit& found, Hit& hit) const;
};

void World::State::open_device() {
    device.reset(rtcNewDevice(nullptr));
    if (!device)
        throw Error::resource("cannot start Embree, the ray tracer");
    rtcSetDeviceErrorFunction(
        device.get(),
        [](void* self, RTCError, const char* text) {
            auto& state = *static_cast<State*>(self);
            const std::lock_guard lock(state.error_mutex);
            if (state.error.empty())
                state.error = text != nullptr && *text != '\0' ? text : "unknown error";
        },
        this);
    rtcSetDeviceMemoryMonitorFunction(
        device.get(),
        [](void* self, ssize_t change, bool) {
            static_cast<State*>(self)->bytes.fetch_add(change, std::memory_order_relaxed);
            return true;
        },
        this);
}

SceneHandle World::State::tree(const Mesh& mesh) const {
    SceneHandle handle = new_scene();
    const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    void* positions =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Vec3), mesh.positions.size());
    if (positions == nullptr)
        return handle; // the device knows why
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3*>(positions));
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.triangles.data(), 0, sizeof(Mesh::Triangle),
                               mesh.triangles.size());
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(handle.get(), geometry.get(), 0);
    rtcCommitScene(handle.get());
    return handle;
}

SharedMesh World::State::shared_mesh(const Mesh& mesh) const {
    SharedMesh made{tree(mesh), triangle_records(mesh), {}};
    made.bounds = bounds_of(made.tree.get());
    return made;
}

void World::State::add_prototypes(std::span<const Aggregate> aggregates, const Context& context) {
    std::map<const Material*, std::uint32_t> numbers{{nullptr, 0}};
    materials.push_back(std::make_shared<const Material>(Matte{}));
    for (const Aggregate& aggregate : aggregates)
        for (const Prototype& prototype : aggregate.prototypes) {
            const Mesh* mesh = mesh_to_draw(aggregate, prototype);
            const auto [number, is_new] = numbers.try_emplace(
                prototype.material.get(), static_cast<std::uint32_t>(materials.size()));
            if (is_new)
                materials.push_back(prototype.material);
            prototypes.push_back({mesh, nullptr, number->second, false, nullptr});
            if (mesh != nullptr && !mesh->triangles.empty() && shared.try_emplace(mesh).second)
                meshes.push_back(std::get<std::shared_ptr<const Mesh>>(prototype.shape));
        }
    parallel_for(meshes.size(), 1, [&](std::size_t i) {
        if (context.cancel == nullptr || !context.cancel->requested())
            shared.find(meshes[i].get())->second = shared_mesh(*meshes[i]);
    });
    context.check_cancel();
    check();
    for (PrototypeRecord& prototype : prototypes)
        if (const auto found = shared.find(prototype.mesh); found != shared.end()) {
            prototype.shared = &found->second;
            prototype.triangles = found->second.triangles.data();
            prototype.has_normals = !prototype.mesh->normals.empty();
        }
}

void World::State::add_instances(std::span<const Aggregate> aggregates) {
    std::uint32_t first_prototype = 0;
    for (const Aggregate& aggregate : aggregates) {
        for (const Instance& instance : aggregate.instances) {
            assert(instance.prototype < aggregate.prototypes.size());
            const std::uint32_t index = first_prototype + instance.prototype;
            instances.push_back(instance_record(instance, index));
        }
        first_prototype += static_cast<std::uint32_t>(aggregate.prototypes.size());
    }
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const InstanceRecord& record = instances[i];
        const Mesh* mesh = prototypes[record.prototype].mesh;
        const auto found = shared.find(mesh);
        if (found == shared.end() || record.scale == 0)
            continue; // nothing to see
        triangles += mesh->triangles.size();
        const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
        rtcSetGeometryInstancedScene(geometry.get(), found->second.tree.get());
        rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                                &record.rows[0]);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometryByID(scene.get(), geometry.get(), static_cast<unsigned>(i));
    }
}

void World::State::add_lights() {
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (const auto* area = std::get_if<AreaLight>(&lights[i])) {
            const Vec3 corner = area->centre - (area->edge_u + area->edge_v) * 0.5F;
            for (const Vec3& p : {corner, corner + area->edge_u,
                                  corner + area->edge_u + area->edge_v, corner + area->edge_v})
                light_vertices.push_back(p);
            light_of_quad.push_back(static_cast<std::uint32_t>(i));
        }
    if (light_of_quad.empty())
        return;
    const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    void* positions =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Vec3), light_vertices.size());
    void* triples =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(Mesh::Triangle), 2 * light_of_quad.size());
    check();
    std::copy(light_vertices.begin(), light_vertices.end(), static_cast<Vec3*>(positions));
    auto* triangle = static_cast<Mesh::Triangle*>(triples);
    for (std::uint32_t quad = 0; quad < light_of_quad.size(); ++quad) {
        *triangle++ = {4 * quad, 4 * quad + 1, 4 * quad + 2};
        *triangle++ = {4 * quad, 4 * quad + 2, 4 * quad + 3};
    }
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene.get(), geometry.get(), static_cast<unsigned>(instances.size()));
}

void World::State::commit(const Context& context) {
    if (context.cancel != nullptr)
        rtcSetSceneProgressMonitorFunction(
            scene.get(),
            [](void* cancel, double) { return !static_cast<const Cancel*>(cancel)->requested(); },
            const_cast<Cancel*>(context.cancel));
    rtcCommitScene(scene.get());
    rtcSetSceneProgressMonitorFunction(scene.get(), nullptr, nullptr);
    context.check_cancel();
    check();
}

World::World(std::span<const Aggregate> aggregates, std::span<const Light> lights,
             const Context& context)
    : state_(std::make_unique<State>()) {
    state_->open_device();
    state_->scene = state_->new_scene();
    state_->check();
    state_->add_prototypes(aggregates, context);
    state_->add_instances(aggregates);
    state_->lights.assign(lights.begin(), lights.end());
    state_->add_lights();
    state_->commit(context);
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

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
        // Normals that vanish or point to the other side say nothing useful.
        if (square > 0 && mixed.dot(hit.normal) > 0) {
            hit.shading_normal = mixed / std::sqrt(square);
            hit.smooth = true;
        }
    }
    hit.mesh = prototype.mesh;
    hit.triangle = found.primitive;
    hit.barycentric = found.barycentric;
    hit.record = &record;
    hit.random = record.random;
    hit.instance = found.instance;
    hit.material = prototype.material;
    hit.light = Hit::none;
}

void World::State::fill_light(const RawHit& found, Hit& hit) const {
    const std::size_t quad = found.primitive / 2;
    const Vec3& corner = light_vertices[4 * quad];
    const Vec3 u = light_vertices[4 * quad + 1] - corner;
    const Vec3 v = light_vertices[4 * quad + 3] - corner;
    hit.normal = hit.shading_normal = u.cross(v).normalized();
    hit.mesh = nullptr;
    hit.random = 0;
    hit.instance = Hit::none;
    hit.material = 0;
    hit.light = light_of_quad[quad];
    hit.smooth = false;
    hit.record = nullptr;
}

Vec2f Hit::uv() const {
    if (mesh == nullptr || mesh->uvs.empty())
        return {0.0F, 0.0F};
    const auto [a, b, c] = mesh->triangles[triangle];
    return mesh->uvs[a] * (1 - barycentric.x - barycentric.y) + mesh->uvs[b] * barycentric.x +
           mesh->uvs[c] * barycentric.y;
}

float Hit::uv_scale() const {
    if (mesh == nullptr || mesh->uvs.empty())
        return 0;
    const auto [a, b, c] = mesh->triangles[triangle];
    const Vec2f u = mesh->uvs[b] - mesh->uvs[a], v = mesh->uvs[c] - mesh->uvs[a];
    const Vec3 p = mesh->positions[b] - mesh->positions[a],
               q = mesh->positions[c] - mesh->positions[a];
    const float area = p.cross(q).length();
    return area > 0 ? std::sqrt(std::abs(u.x * v.y - u.y * v.x) / area) : 0;
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
    const SharedMesh* shared = state_->prototypes[record.prototype].shared;
    assert(shared != nullptr);
    const Vec3 origin = record.inverse_direction(ray.origin - record.rows[3]);
    if (!shared->bounds.intersects(origin))
        return std::nullopt;
    const RTCRayHit query = first_hit(shared->tree.get(), origin,
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
    __builtin_prefetch(&state_->prototypes[record.prototype].triangles[raw.primitive]);
}

void World::fill(const Ray& ray, const RawHit& raw, Hit& hit) const {
    assert(raw.found());
    if (raw.instance == Hit::none) {
        state_->fill_light(raw, hit);
        hit.position = ray.origin + ray.direction * raw.distance;
        hit.offset = rounding * largest(hit.position);
    } else {
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
    RTCRay query;
    query.org_x = ray.origin.x;
    query.org_y = ray.origin.y;
    query.org_z = ray.origin.z;
    query.dir_x = ray.direction.x;
    query.dir_y = ray.direction.y;
    query.dir_z = ray.direction.z;
    query.tnear = 0;
    query.tfar = ray.length;
    query.time = 0;
    query.mask = 0xffffffffU;
    query.id = 0;
    query.flags = 0;
    if (clock != nullptr) {
        const std::uint64_t start = ticks();
        embree::occluded(state_->scene.get(), query);
        *clock += ticks() - start;
    } else {
        embree::occluded(state_->scene.get(), query);
    }
    return query.tfar < 0; // Embree's sign of a hit
}

Box3 World::bounds() const { return bounds_of(state_->scene.get()); }

std::size_t World::instance_count() const { return state_->instances.size(); }
std::size_t World::triangle_count() const { return state_->triangles; }
std::span<const std::shared_ptr<const Material>> World::materials() const {
    return state_->materials;
}
std::span<const Light> World::lights() const { return state_->lights; }

std::size_t World::memory_bytes() const {
    std::size_t records = state_->instances.size() * sizeof(InstanceRecord);
    for (const auto& [mesh, shared] : state_->shared)
        records += shared.triangles.size() * sizeof(TriangleRecord);
    return static_cast<std::size_t>(std::max<std::int64_t>(0, state_->bytes.load())) + records;
}

} // namespace scree
