// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "geometry/figures/collision_shape.h"

#include <memory>

namespace scree {

/// Where elements may lie.
enum class Inside {
    whole,  // no part of a region sticks out of the domain
    centre, // the centre of the region's bounding box lies in it
    torus   // as for centre, and what leaves the domain, a rectangle, comes back on the other side
};

/// Asks whether an element lies in the domain, and draws points in it. The domain's edges are
/// sorted into a grid, so that the work does not grow with their number.
class DomainTest {
  public:
    DomainTest(std::shared_ptr<const Region> domain, Inside inside);

    /// Whether the element lies in the domain and, when whole, at least `clearance` [m] from its
    /// border. In double, with a tolerance of 1e-12 of the domain's size; within it the answer is
    /// no.
    bool accepts(const CollisionShape& shape, const FigurePose& pose, double clearance = 0) const;

    bool contains_point(const Vec2& point) const;

    bool is_torus() const { return inside_ == Inside::torus; }

    /// On a torus the image of the point in the box, and the shortest image of the vector; on a
    /// plane the arguments themselves.
    Vec2 wrapped(const Vec2& point) const;
    Vec2 nearest_image(const Vec2& offset) const;

    /// A point uniformly distributed over the domain.
    Vec2 sample(Random& random) const;

    const Region& region() const { return *domain_; }
    const Box2& box() const { return box_; }
    Inside inside() const { return inside_; }

  private:
    struct Edge {
        Vec2 from;
        Vec2 to;
    };
    template <class Visit>
    void visit_edges_near(const Vec2& point, double distance, const Visit& visit) const;
    int column(double x) const;
    int row(double y) const;

    std::shared_ptr<const Region> domain_;
    Inside inside_;
    Box2 box_;
    Vec2 period_; // of a torus, otherwise infinite
    double tolerance_ = 0;
    std::vector<double> triangle_sums_; // running sum of areas
    int cells_ = 1;                     // per side
    std::vector<std::vector<Edge>> grid_;
};

} // namespace scree
