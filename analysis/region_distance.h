// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/box_grid.h"
#include "analysis/placed_regions.h"

namespace scree {

/// Distances to placed regions, with a spatial index of their edges: a query takes about a
/// microsecond independent of the number of regions. On a torus all periodic images count.
class RegionDistance {
  public:
    /// `regions` must outlive this and have outlines.
    explicit RegionDistance(const PlacedRegions& regions);

    /// Signed distance from the point to the nearest edge of a region [m]: positive outside all
    /// regions, negative or 0 inside one; infinity when there are none.
    double operator()(const Vec2& point) const;

    /// Whether the point lies in a region.
    bool inside(const Vec2& point) const;

    /// Distance from the outline of one element to the nearest other outline [m], on a torus also
    /// to its own images; 0 if they touch; infinity when there is none.
    double to_neighbour(std::uint32_t element) const;

  private:
    struct Edge {
        Vec2 a;
        Vec2 b;
        std::uint32_t element;
    };
    static std::vector<Edge> edges_of(const PlacedRegions& regions);
    static std::vector<Box2> boxes_of(const std::vector<Edge>& edges);
    static std::vector<Box2> boxes_of(const PlacedRegions& regions);

    const PlacedRegions& regions_;
    Box2 frame_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> first_edge_; // per element, and one more
    std::vector<Box2> element_boxes_;
    BoxGrid edge_grid_;
    BoxGrid element_grid_;
};

} // namespace scree
