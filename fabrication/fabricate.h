// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "model/aggregate.h"

#include <span>

namespace scree {

struct FabricationOptions {
    double resolution = 0; // side of a cell [m]; 0: a tenth of the thinnest component's thickness
    double bridge = 0;     // gaps narrower than twice this are closed [m]
    bool keep_parts = false;
    bool keep_voids = false;
    std::size_t memory = 0; // most to use [bytes]; 0: what the machine has available
};

/// A component that is not the surface of a solid: it has a border, or is of strands, or there is
/// no shape at all.
struct OpenComponent {
    std::size_t aggregate = 0; // index
    std::string name;
    bool has_mesh = true;
    bool has_strands = false;
    MeshFacts facts;
    std::size_t instances = 0;
};

/// Those of which there are instances.
std::vector<OpenComponent> open_components(std::span<const Aggregate> aggregates);

/// One connected piece of the union.
struct FabricationPart {
    double volume = 0; // [m^3]
    std::size_t triangles = 0;
};

struct Fabrication {
    Mesh mesh; // kept parts, in the world [m]
    double resolution = 0;
    std::size_t solids = 0;               // instances that were united
    std::vector<FabricationPart> parts;   // kept, the largest first
    std::vector<FabricationPart> removed; // not connected with the largest, the largest first
    std::size_t voids = 0;                // enclosed cavities of the kept parts
    double void_volume = 0;               // [m^3]
    bool voids_kept = false;
};

/// The union of all instances of closed components as a closed 2-manifold with outward normals that
/// does not meet itself, within about half a cell of the true surface; what is thinner than a cell
/// may be lost. Open components are left out. Unless asked to keep them, all parts but the largest
/// are removed and enclosed voids are filled. The bridge is a morphological closing (dilation, then
/// erosion, by balls; Serra 1982). The same result on any number of threads.
///
/// Throws Error: input where nothing is left or options do not fit the sizes, resource where the
/// memory does not suffice.
Fabrication fabricate(std::span<const Aggregate> aggregates, const FabricationOptions& options,
                      const Context& context);

} // namespace scree
