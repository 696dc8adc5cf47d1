// SPDX-License-Identifier: GPL-3.0-or-later
// The instances of a world, in one of two ways: few as Embree's own instances, which cost 370 bytes
// each beside their records; many as one user geometry, whose primitives are the records themselves
// and cost 80 (docs/instances.md).
#include "render/world/world_state.h"

#include <cassert>

namespace scree {

using embree::GeometryHandle;

namespace {

bool shown(const PrototypeRecord& prototype, const InstanceRecord& record) {
    return prototype.tree != nullptr && record.scale != 0;
}

// Bound of the rounding errors of a box's own transformation, per unit of coordinate: about 8
// roundings of 2^-24, twice over for safety.
constexpr float rounding = 0x1p-20F;

// The box of an instance of a shape with the box `object`.
Box3 world_box(const InstanceRecord& record, const Box3& object) {
    const Vec3 half = (object.max - object.min) * 0.5F;
    const Vec3 middle = object.min + half;
    const Vec3 centre = record.point(middle);
    Vec3 reach(0.0F);
    for (int axis = 0; axis < 3; ++axis) {
        float slack = std::abs(record.rows[3][axis]);
        for (int i = 0; i < 3; ++i) {
            const float stretch = std::abs(record.rows[i][axis]);
            reach[axis] += stretch * half[i];
            slack += stretch * (std::abs(middle[i]) + half[i]);
        }
        reach[axis] += rounding * slack;
    }
    return {centre - reach, centre + reach};
}

// That of an instance of the shape: narrower where its reach is known.
Box3 world_box(const InstanceRecord& record, const ShapeTree& tree) {
    const SupportFunction& support = tree.support;
    Box3 box = world_box(record, tree.bounds);
    if (!support.known())
        return box;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 along(record.rows[0][axis], record.rows[1][axis], record.rows[2][axis]);
        const float at = record.rows[3][axis];
        const float slack = rounding * std::max(std::abs(box.min[axis]), std::abs(box.max[axis]));
        box.max[axis] = std::min(box.max[axis], at + support(along) + slack);
        box.min[axis] = std::max(box.min[axis], at - support(-along) - slack);
    }
    return box;
}

// The ray in the frame of the instance. Its direction gets another length, so that distances stay
// as they are.
RTCRay within(const InstanceRecord& record, const RTCRay& ray) {
    return embree::make_ray(record.inverse_direction(embree::origin(ray) - record.rows[3]),
                            record.inverse_direction(embree::direction(ray)), 0);
}

} // namespace

void World::State::add_instances(std::span<const Aggregate> aggregates, std::size_t many) {
    std::size_t count = 0;
    for (const Aggregate& aggregate : aggregates)
        count += aggregate.instances.size();
    instances.reserve(count);
    std::uint32_t first_prototype = 0;
    for (const Aggregate& aggregate : aggregates) {
        for (const Instance& instance : aggregate.instances) {
            assert(instance.prototype < aggregate.prototypes.size());
            const std::uint32_t index = first_prototype + instance.prototype;
            instances.push_back(instance_record(instance, index, origin));
            count_shapes(instances.back());
        }
        first_prototype += static_cast<std::uint32_t>(aggregate.prototypes.size());
    }
    if (instances.size() >= many)
        attach_together();
    else
        attach_each();
}

void World::State::count_shapes(const InstanceRecord& record) {
    const PrototypeRecord& prototype = prototypes[record.prototype];
    if (!shown(prototype, record))
        return;
    if (prototype.strands != nullptr) {
        strand_figures.strands += prototype.strands->strands->count();
        strand_figures.segments += prototype.strands->strands->segment_count();
    } else {
        triangles += prototype.mesh->triangles.size();
    }
}

void World::State::attach_each() {
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const InstanceRecord& record = instances[i];
        const PrototypeRecord& prototype = prototypes[record.prototype];
        if (!shown(prototype, record))
            continue;
        const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
        rtcSetGeometryInstancedScene(geometry.get(), prototype.tree->scene.get());
        rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                                &record.rows[0]);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometryByID(scene.get(), geometry.get(), static_cast<unsigned>(i));
        bytes += embree::unreported_bytes;
    }
}

template <class Arguments>
void World::State::enter(const Arguments* args) {
    assert(args->N == 1 && args->valid[0] != 0);
    const State& state = *static_cast<const State*>(args->geometryUserPtr);
    const InstanceRecord& record = state.instances[args->primID];
    RTCRay ray = within(record, embree::ray_of(*args));
    embree::go_on(*args, state.prototypes[record.prototype].tree->scene.get(), ray, args->primID);
}

void World::State::find_supports() {
    for (auto& [mesh, tree] : mesh_trees)
        if (tree.is_shared_by_many())
            tree.support = SupportFunction(mesh->positions);
}

void World::State::attach_together() {
    find_supports();
    const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(instances.size()));
    rtcSetGeometryUserData(geometry.get(), this);
    rtcSetGeometryBoundsFunction(
        geometry.get(),
        [](const RTCBoundsFunctionArguments* args) {
            const State& state = *static_cast<const State*>(args->geometryUserPtr);
            const InstanceRecord& record = state.instances[args->primID];
            const PrototypeRecord& prototype = state.prototypes[record.prototype];
            // Embree leaves out what has an empty box.
            const Box3 box = shown(prototype, record) ? world_box(record, *prototype.tree) : Box3();
            *args->bounds_o = {box.min.x, box.min.y, box.min.z, 0,
                               box.max.x, box.max.y, box.max.z, 0};
        },
        nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), enter<RTCIntersectFunctionNArguments>);
    rtcSetGeometryOccludedFunction(geometry.get(), enter<RTCOccludedFunctionNArguments>);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene.get(), geometry.get(), 0);
}

} // namespace scree
