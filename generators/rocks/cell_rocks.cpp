// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/cell_rocks.h"

#include "core/random.h"

namespace scree::rocks {

Ring convex_outline(const RocksSettings& settings) {
    const std::vector<Ring>& rings = settings.domain->rings;
    const char* hint = "expected a convex region without holes, such as region.rectangle";
    if (rings.size() != 1)
        throw settings.domain_place.error("is of several parts or has holes", hint);
    const Ring& ring = rings.front();
    const double extent = bounds(*settings.domain).size().length();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2& a = ring[i];
        const Vec2& b = ring[(i + 1) % ring.size()];
        const Vec2& c = ring[(i + 2) % ring.size()];
        if (cross(b - a, c - b) < -1e-9 * extent * extent)
            throw settings.domain_place.error("is not convex", hint);
    }
    return ring;
}

Aggregate aggregate_of(std::vector<Mesh> meshes, std::span<const std::size_t> kinds,
                       const RocksSettings& settings) {
    Aggregate aggregate;
    aggregate.generator = "rocks";
    aggregate.seed = settings.seed;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        // About its own middle, so that a mesh is as precise far from the origin as near it.
        const Vec3 middle = bounds(meshes[i]).center();
        for (Vec3& p : meshes[i].positions)
            p -= middle;
        WideMatrix place;
        place.setTranslation(WideVec3(middle));
        Materials materials;
        if (!settings.materials.empty())
            materials = {settings.materials[kinds[i] % settings.materials.size()]};
        std::string name = meshes[i].name;
        aggregate.instances.push_back(
            {.prototype = static_cast<std::uint32_t>(i),
             .world_from_object = place,
             .random = Random(settings.seed, Purpose::instance_attribute, i).uniform_float()});
        aggregate.prototypes.push_back({.name = std::move(name),
                                        .shape = std::make_shared<const Mesh>(std::move(meshes[i])),
                                        .materials = std::move(materials)});
    }
    return aggregate;
}

} // namespace scree::rocks
