// SPDX-License-Identifier: GPL-3.0-or-later
// Embree's scene and the records beside it, made of aggregates.
#include "core/error.h"
#include "core/parallel.h"
#include "render/world/world_state.h"

#include <algorithm>
#include <cassert>

namespace scree {

using embree::GeometryHandle;
using embree::SceneHandle;

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
            auto& state = *static_cast<State*>(self);
            const std::int64_t now = state.bytes += change;
            std::int64_t peak = state.peak_bytes;
            while (now > peak && !state.peak_bytes.compare_exchange_weak(peak, now)) {
            }
            return true;
        },
        this);
}

void World::State::check() {
    const std::lock_guard lock(error_mutex);
    if (!error.empty())
        throw Error::resource("cannot build the scene for rendering: " + error);
}

SceneHandle World::State::new_scene() const {
    SceneHandle handle(rtcNewScene(device.get()));
    rtcSetSceneFlags(handle.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(handle.get(), RTC_BUILD_QUALITY_MEDIUM);
    return handle;
}

SceneHandle World::State::tree(const Mesh& mesh, bool careful) const {
    SceneHandle handle = new_scene();
    if (careful) // rays meet it 6 % faster; it takes about three times as long to build
        rtcSetSceneBuildQuality(handle.get(), RTC_BUILD_QUALITY_HIGH);
    const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    void* positions =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Vec3), mesh.positions.size());
    if (positions == nullptr)
        return handle; // `check` reports why
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3*>(positions));
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.triangles.data(), 0, sizeof(Mesh::Triangle),
                               mesh.triangles.size());
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(handle.get(), geometry.get(), 0);
    rtcCommitScene(handle.get());
    return handle;
}

void World::State::build(const Mesh& mesh, MeshTree& tree_of) const {
    tree_of.scene = tree(mesh, tree_of.is_shared_by_many());
    tree_of.bounds = embree::bounds(tree_of.scene.get());
    tree_of.triangles = triangle_records(mesh);
}

void World::State::collect(const std::shared_ptr<const Mesh>& mesh,
                           const Prototype& /*prototype*/) {
    if (mesh != nullptr && !mesh->triangles.empty() && mesh_trees.try_emplace(mesh.get()).second)
        meshes.push_back(mesh);
}

namespace {

bool any_uses_uv(const Materials& materials) {
    return std::any_of(materials.begin(), materials.end(),
                       [](const auto& material) { return material && uses_uv(*material); });
}

/// Light goes through a fibre at once, so it must be round and have an axis.
void check_fibre(const Prototype& prototype, const Aggregate& of) {
    if (prototype.mesh() != nullptr && any_fibre(prototype.materials))
        throw Error(Diagnostic{of.where, title(of),
                               prototype.name + " is a mesh; material.fibre is for strands", ""});
}

/// Light that walks inside of a shape must come out where it is of the same kind.
void check_parts(const Prototype& prototype, const Aggregate& of) {
    const Materials& materials = prototype.materials;
    if (materials.size() < 2)
        return;
    const bool walks = std::any_of(materials.begin(), materials.end(), [](const auto& material) {
        return material && std::holds_alternative<Translucent>(*material);
    });
    if (walks)
        throw Error(Diagnostic{of.where, of.generator,
                               prototype.name + " is translucent in part; a translucent material "
                                                "must be that of the whole mesh",
                               ""});
    [[maybe_unused]] const Mesh* mesh = prototype.mesh();
    assert(mesh == nullptr || mesh->parts.empty() ||
           *std::max_element(mesh->parts.begin(), mesh->parts.end()) < materials.size());
}

} // namespace

void World::State::build_mesh_trees(const Context& context) {
    parallel_for(meshes.size(), 1, [&](std::size_t i) {
        if (context.cancel == nullptr || !context.cancel->requested())
            build(*meshes[i], mesh_trees.find(meshes[i].get())->second);
    });
    context.check_cancel();
    check();
}

void World::State::add_prototypes(std::span<const Aggregate> aggregates, const Context& context) {
    std::map<Materials, std::uint32_t> numbers{{{}, 0}, {{nullptr}, 0}};
    materials.push_back(std::make_shared<const Material>(Matte{}));
    for (const Aggregate& aggregate : aggregates) {
        for (const Prototype& prototype : aggregate.prototypes) {
            std::visit([&](const auto& shape) { collect(shape, prototype); }, prototype.shape);
            check_parts(prototype, aggregate);
            check_fibre(prototype, aggregate);
            const auto [number, is_new] = numbers.try_emplace(
                prototype.materials, static_cast<std::uint32_t>(materials.size()));
            if (is_new)
                for (const std::shared_ptr<const Material>& material : prototype.materials)
                    materials.push_back(material ? material : materials.front());
            prototypes.push_back({.mesh = prototype.mesh(),
                                  .material = number->second,
                                  .by_part = prototype.materials.size() > 1,
                                  .uses_uv = any_uses_uv(prototype.materials)});
        }
        for (const Instance& instance : aggregate.instances) {
            const auto tree = mesh_trees.find(aggregate.prototypes[instance.prototype].mesh());
            if (tree != mesh_trees.end())
                ++tree->second.instances;
        }
    }
    build_mesh_trees(context);
    build_strand_trees(context);
    std::size_t number = 0;
    for (const Aggregate& aggregate : aggregates)
        for (const Prototype& prototype : aggregate.prototypes)
            find_tree(prototype, prototypes[number++]);
}

void World::State::find_tree(const Prototype& prototype, PrototypeRecord& record) const {
    if (const auto mesh = mesh_trees.find(prototype.mesh()); mesh != mesh_trees.end()) {
        record.tree = &mesh->second;
        record.triangles = mesh->second.triangles.data();
        record.has_normals = !prototype.mesh()->normals.empty();
    }
    const auto found = strand_trees.find({prototype.strands(), any_fibre(prototype.materials)});
    if (found != strand_trees.end())
        record.tree = record.strands = &found->second;
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
             const Context& context, const WideVec3& origin, const WorldLimits& limits)
    : state_(std::make_unique<State>()) {
    state_->origin = origin;
    state_->most_chords = limits.most_chords;
    state_->open_device();
    state_->scene = state_->new_scene();
    state_->check();
    state_->add_prototypes(aggregates, context);
    state_->add_instances(aggregates, limits.many_instances);
    state_->lights.assign(lights.begin(), lights.end());
    for (Light& light : state_->lights)
        if (auto* area = std::get_if<AreaLight>(&light))
            area->centre -= origin;
    state_->add_area_lights();
    state_->commit(context);
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

} // namespace scree
