// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "model/aggregate.h"

#include <span>

namespace scree {

struct FabricationOptions {
    double resolution = 0; // side of a cell [m]; 0: a tenth of the smallest thickness
    double bridge = 0;     // radius of the closing [m]: closes gaps narrower than twice this
    bool keep_parts = false;
    bool keep_voids = false;
    std::size_t memory = 0; // limit [bytes]; 0: the available memory
};

/// A component that is not the surface of a solid: its mesh has a border, or it has no mesh.
struct OpenComponent {
    std::size_t aggregate = 0; // index
    std::string name;
    bool has_mesh = true;
    bool has_strands = false;
    MeshFacts facts;
    std::size_t instances = 0;
};

/// All open components that have instances.
std::vector<OpenComponent> open_components(std::span<const Aggregate> aggregates);

/// One connected part of the union.
struct FabricationPart {
    double volume = 0; // [m^3]
    std::size_t triangles = 0;
};

struct Fabrication {
    Mesh mesh; // of the kept parts, in world space [m]
    double resolution = 0;
    std::size_t solids = 0;               // instances that were united
    std::vector<FabricationPart> parts;   // those kept, the largest first
    std::vector<FabricationPart> removed; // those not connected to the largest, the largest first
    std::size_t voids = 0;                // enclosed cavities of the kept parts
    double void_volume = 0;               // [m^3]
    bool voids_kept = false;
};

/// The union of all instances of closed components as a closed 2-manifold without
/// self-intersections, within about half a cell of the exact surface; parts thinner than a cell may
/// be lost. Open components are left out. By default all parts except the largest are removed and
/// enclosed voids are filled. Bridging is a morphological closing by a ball (Serra 1982). The
/// result does not depend on the number of threads.
///
/// Throws Error: input when nothing is left or the options do not fit the sizes, resource when
/// there is not enough memory.
Fabrication fabricate(std::span<const Aggregate> aggregates, const FabricationOptions& options,
                      const Context& context);

} // namespace scree
