// SPDX-License-Identifier: GPL-3.0-or-later
#include "fabrication/solids.h"

#include "fabrication/fabricate.h"

#include <algorithm>
#include <limits>
#include <map>

namespace scree {

namespace {

double thickness(const Solid& solid, const Vec3& size) {
    // Per axis, so that a mesh squeezed along one axis counts as thin.
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const WideVec3 row(solid.world_from_object[axis][0], solid.world_from_object[axis][1],
                           solid.world_from_object[axis][2]);
        least = std::min(least, double(size[axis]) * row.length());
    }
    return least;
}

} // namespace

std::vector<OpenComponent> open_components(std::span<const Aggregate> aggregates) {
    std::vector<OpenComponent> out;
    for (std::size_t a = 0; a < aggregates.size(); ++a) {
        std::vector<std::size_t> instances(aggregates[a].prototypes.size());
        for (const Instance& instance : aggregates[a].instances)
            ++instances[instance.prototype];
        for (std::size_t p = 0; p < instances.size(); ++p) {
            const Prototype& prototype = aggregates[a].prototypes[p];
            if (instances[p] == 0)
                continue;
            const Mesh* mesh = prototype.mesh();
            OpenComponent component{.aggregate = a,
                                    .name = prototype.name,
                                    .has_mesh = mesh != nullptr,
                                    .has_strands = prototype.strands() != nullptr,
                                    .facts = {},
                                    .instances = instances[p]};
            if (mesh != nullptr)
                component.facts = inspect(*mesh);
            if (mesh == nullptr || !component.facts.closed())
                out.push_back(component);
        }
    }
    return out;
}

std::vector<Solid> closed_solids(std::span<const Aggregate> aggregates) {
    std::vector<Solid> out;
    std::map<const Mesh*, bool> closed; // prototypes may share a mesh
    for (const Aggregate& aggregate : aggregates)
        for (const Instance& instance : aggregate.instances) {
            const Mesh* mesh = aggregate.prototypes[instance.prototype].mesh();
            if (mesh == nullptr)
                continue;
            const auto [known, is_new] = closed.try_emplace(mesh);
            if (is_new)
                known->second = inspect(*mesh).closed();
            if (known->second)
                out.push_back({mesh, instance.world_from_object});
        }
    return out;
}

double thinnest(std::span<const Solid> solids) {
    std::map<const Mesh*, Vec3> sizes;
    double least = std::numeric_limits<double>::infinity();
    for (const Solid& solid : solids) {
        const auto [size, is_new] = sizes.try_emplace(solid.mesh);
        if (is_new)
            size->second = bounds(*solid.mesh).size();
        least = std::min(least, thickness(solid, size->second));
    }
    return least;
}

double farthest(std::span<const Solid> solids) {
    std::map<const Mesh*, Box3> boxes;
    double most = 0;
    for (const Solid& solid : solids) {
        const auto [box, is_new] = boxes.try_emplace(solid.mesh);
        if (is_new)
            box->second = bounds(*solid.mesh);
        for (int corner = 0; corner < 8; ++corner) {
            Vec3 p;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = (corner >> axis & 1) != 0 ? box->second.max[axis] : box->second.min[axis];
            const WideVec3 there = WideVec3(p) * solid.world_from_object;
            most = std::max({most, std::abs(there.x), std::abs(there.y), std::abs(there.z)});
        }
    }
    return most;
}

} // namespace scree
