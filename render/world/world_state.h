// SPDX-License-Identifier: GPL-3.0-or-later
// What a World holds; for the files that build it and answer its rays.
#pragma once

#include "render/world/instance_record.h"
#include "render/world/strand_tree.h"
#include "render/world/triangle_record.h"
#include "render/world/world.h"

#include <atomic>
#include <map>
#include <mutex>
#include <vector>

namespace scree {

/// What instances of one mesh share.
struct MeshTree : ShapeTree {
    std::vector<TriangleRecord> triangles;
};

struct PrototypeRecord {
    const Mesh* mesh = nullptr;
    const TriangleRecord* triangles = nullptr;
    std::uint32_t material = 0; // the first of its materials
    bool by_part = false;       // the others follow, by the parts of the mesh
    bool has_normals = false;
    bool uses_uv = false;                // a material does, so hits must carry it
    const ShapeTree* tree = nullptr;     // null where there is nothing to see
    const StrandTree* strands = nullptr; // the same, of strands
};

struct World::State {
    // How much memory Embree uses, the most it did, and the first of its errors; Embree's threads
    // write them.
    std::atomic<std::int64_t> bytes = 0;
    std::atomic<std::int64_t> peak_bytes = 0;
    std::mutex error_mutex;
    std::string error;

    // Destroyed from the last to the first: the trees before the device.
    embree::DeviceHandle device;
    std::map<const Mesh*, MeshTree> mesh_trees;
    std::vector<std::shared_ptr<const Mesh>> meshes; // those of mesh_trees, kept alive
    std::map<std::pair<const Strands*, bool>, StrandTree> strand_trees; // true: of fibres
    std::vector<std::shared_ptr<const Strands>> strands;                // likewise kept alive
    std::vector<PrototypeRecord> prototypes; // of all aggregates, one after the other
    std::vector<InstanceRecord> instances;   // likewise
    std::vector<std::shared_ptr<const Material>> materials; // first that of what has none
    WideVec3 origin{0, 0, 0};                               // what all below is relative to
    std::vector<Light> lights;
    std::vector<std::uint32_t> light_of_quad; // of each area light, its index into `lights`
    std::vector<Vec3> light_vertices;         // four for each area light
    embree::SceneHandle scene;
    std::size_t most_chords = 0;
    std::size_t triangles = 0; // of all instances
    StrandFigures strand_figures;

    void open_device();
    /// Throws Error (resource) when Embree has reported an error.
    void check();
    embree::SceneHandle new_scene() const;
    void commit(const Context& context);

    // Shapes: one function for each kind.
    void collect(const std::shared_ptr<const Mesh>& mesh, const Prototype& prototype);
    void collect(const std::shared_ptr<const Strands>& shape, const Prototype& prototype);
    void build_mesh_trees(const Context& context);
    void add_caps(StrandTree& tree) const;
    void build_strand_trees(const Context& context);
    void build(const Mesh& mesh, MeshTree& tree_of) const;
    StrandTree build(const Strands& shape, bool is_fibre) const;
    embree::SceneHandle tree(const Mesh& mesh, bool careful) const;
    void find_tree(const Prototype& prototype, PrototypeRecord& record) const;

    void add_prototypes(std::span<const Aggregate> aggregates, const Context& context);
    // Instances: `many` are one geometry of ours, fewer are one of Embree's each.
    void add_instances(std::span<const Aggregate> aggregates, std::size_t many);
    void count_shapes(const InstanceRecord& record);
    void attach_each();
    void attach_together();
    void find_supports();
    template <class Arguments>
    static void enter(const Arguments* args);

    void add_area_lights();

    std::size_t record_bytes() const;

    void fill_surface(const RawHit& found, Hit& hit) const;
    void fill_strand(const Ray& ray, const RawHit& found, Hit& hit) const;
    void fill_light(const RawHit& found, Hit& hit) const;
};

} // namespace scree
