// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of generator.layout, read once.
#pragma once

#include "generators/layout/method.h"
#include "geometry/mesh/mesh.h"
#include "model/file_material.h"

namespace scree {

enum class LayoutMethod { naive, fill_gap, saturated };

/// One component of a layout. Its shape is a mesh or a region.
struct LayoutComponent {
    std::shared_ptr<const Mesh> mesh;           // the shape, if it is a mesh
    std::shared_ptr<const Region> flat_shape;   // the shape, if it is a region
    std::shared_ptr<const Region> given_region; // replaces the shape's own outline; may be null
    Materials materials;
    double weight = 1;
    double margin = 0; // [m]
    long class_number = 0;
    double height = 0; // [m]

    ParamPlace shape_place;
    ParamPlace region_place; // of the region, or of the shape where none is given
    ParamPlace margin_place;
};

/// Lengths in metres, angles in radians.
struct LayoutSettings {
    std::optional<LayoutMethod> method; // nothing: what suits the problem
    bool counts_darts = false;          // the script says how many cancelled trials end the work
    std::shared_ptr<const Region> domain;
    Inside inside = Inside::whole;
    std::vector<LayoutComponent> components;
    Selection selection = Selection::cyclic;
    LayoutFields fields;
    Range rotation{0, 2 * pi};
    Range scale{1, 1};
    std::uint64_t seed = 0;
    std::size_t max_count = std::numeric_limits<std::size_t>::max();
    FillGapSettings fill_gap;
    std::uint64_t naive_cancellations = 10000; // in a row, that end the naive method
    double epsilon_share = 0; // of the smallest inscribed radius, the saturated method's clearance

    ParamPlace domain_place;
    ParamPlace torus_place;
    ParamPlace components_place;
    ParamPlace epsilon_place;
};

/// Reads parameters that `layout_specs` declares. What they refer to, such as the domain's area, is
/// not examined here.
LayoutSettings layout_settings(const Params& params);

} // namespace scree
