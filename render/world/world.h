// SPDX-License-Identifier: GPL-3.0-or-later
// What rays meet: the only owner of Embree's handles.
#pragma once

#include "core/context.h"
#include "model/aggregate.h"
#include "model/light.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>

namespace scree {

struct InstanceRecord;

struct Ray {
    Vec3 origin;
    Vec3 direction; // unit length
    float length = std::numeric_limits<float>::infinity();
};

/// What a ray meets first.
struct Hit {
    static constexpr std::uint32_t none = 0xffffffffU;

    Vec3 position;
    Vec3 normal;         // geometric, unit, outwards (of a mesh: by the order of the vertices)
    Vec3 shading_normal; // interpolated, unit, on the same side as `normal`
    Vec3 object_position;
    float distance = 0;
    float level = 0;  // y of the position in the scene [m]
    float offset = 0; // how far the position may be off its surface [m]
    float random = 0; // of the instance, shifted by that of the strand
    std::uint32_t instance = none;
    std::uint32_t material = 0;             // index into World::materials
    std::uint32_t light = none;             // index into the lights, of an area light
    bool smooth = false;                    // shading_normal differs from normal
    const InstanceRecord* record = nullptr; // the object's frame; null on lights

    // Found only where the material uses them (see uses_uv), and 0 elsewhere.
    // 0 where the mesh has none; of a strand how far towards the tip, in parts of its length, and
    // how far across its width, as the ray sees it
    Vec2f uv{0.0F, 0.0F};
    float uv_per_metre = 0; // of the object, by the triangle's areas; 0 where the mesh has no UVs
    // dp/du, unit, of a strand along its axis; where there is none, any square to `normal`
    Vec3 tangent{0.0F, 0.0F, 0.0F};

    /// A ray that leaves the surface and cannot meet it again by rounding.
    Ray leave(const Vec3& direction) const {
        const float side = direction.dot(normal) > 0 ? offset : -offset;
        return {position + normal * side, direction};
    }
};

/// How much of a world is strands.
struct StrandFigures {
    std::size_t strands = 0;  // after instancing
    std::size_t segments = 0; // likewise
    std::size_t bytes = 0;    // of Embree's trees and buffers of them, which instances share
};

/// A hit as Embree reports it; `World::fill` makes a Hit of it.
struct RawHit {
    std::uint32_t geometry = Hit::none; // none: the ray met nothing
    std::uint32_t instance = Hit::none;
    std::uint32_t primitive = 0;
    Vec2f barycentric{0.0F, 0.0F};
    float distance = 0;

    bool found() const { return geometry != Hit::none; }
};

/// Where a world changes from one way to keep what it holds to another.
struct WorldLimits {
    /// From so many instances on all are kept together, which takes a third of the memory and less
    /// time (docs/instances.md).
    std::size_t many_instances = 1'000;

    /// A shape's splines are chains of cones, which rays meet half as fast again as Embree's own
    /// splines, unless they would be more than so many: they take more memory.
    std::size_t most_chords = 1'000'000;
};

/// Aggregates and area lights, ready for rays. Prototypes that share a shape share its tree, the
/// bounding volumes in which Embree finds it. Thread-safe once built.
class World {
  public:
    /// Rays, hits and lights are relative to `origin`: near the camera, so that what is seen there
    /// keeps its precision however far from the scene's own origin it lies. Keeps the meshes and
    /// strands alive, not the aggregates. Throws Error (resource) when Embree runs out of memory,
    /// Error (input) for a material that its shape cannot have, Cancelled on the context's cancel.
    /// The limits are the defaults but for tests and measurements.
    World(std::span<const Aggregate> aggregates, std::span<const Light> lights,
          const Context& context = {}, const WideVec3& origin = WideVec3(0),
          const WorldLimits& limits = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    /// The first hit along the ray, if any. Adds the time inside Embree to `*clock` if given.
    bool hit(const Ray& ray, Hit& hit, std::uint64_t* clock = nullptr) const;

    /// `hit` in three steps. What a bounced ray hits is in no cache: a caller with several rays
    /// takes each step for all of them, so that memory is fetched meanwhile.
    RawHit find(const Ray& ray, std::uint64_t* clock = nullptr) const;
    void prefetch(const RawHit& raw) const;
    void fill(const Ray& ray, const RawHit& raw, Hit& hit) const;

    /// What a ray meets of one instance, as if nothing else were there; nullopt where the ray
    /// begins outside of the shape's bounding box.
    std::optional<RawHit> find_within(std::uint32_t instance, const Ray& ray,
                                      std::uint64_t* clock = nullptr) const;

    /// Whether anything lies within the ray's length.
    bool occluded(const Ray& ray, std::uint64_t* clock = nullptr) const;

    /// By Hit::material; the first is that of prototypes without a material.
    std::span<const std::shared_ptr<const Material>> materials() const;
    std::span<const Light> lights() const; // relative to the origin
    const WideVec3& origin() const;        // in the scene [m]

    Box3 bounds() const; // empty for an empty world
    std::size_t instance_count() const;
    std::size_t triangle_count() const; // after instancing
    const StrandFigures& strand_figures() const;
    std::size_t memory_bytes() const; // of Embree's trees and of the records beside them
    std::size_t peak_bytes() const;   // the most that it has been while they were built

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace scree
