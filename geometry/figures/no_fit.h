// SPDX-License-Identifier: GPL-3.0-or-later
// Where one convex piece may not lie because of another: no-fit polygons for whole intervals of
// angles and scales.
#pragma once

#include "core/float4.h"
#include "core/math.h"
#include "geometry/plane/region.h"

#include <vector>

namespace scree {

/// A convex polygon in its shape's frame, as edges' outward normals and offsets. Sharp corners have
/// further normals, so that moving every edge outwards by some length moves no corner by more than
/// that length / `corner_cosine`.
struct ConvexPiece {
    std::vector<Vec2> vertices;
    std::vector<Vec2> normals;
    std::vector<double> offsets; // normal . x <= offset
    Vec2 centre;
    double radius = 0; // of a circle around the centre that holds the polygon [m]
    double corner_cosine = 1;

    /// `corner`: the largest angle between neighbouring normals [rad], at least pi / 2^20.
    ConvexPiece(const Ring& ring, double corner);

    /// Whether some point of it may be within `distance` [m] of the point.
    bool is_near(const Vec2& point, double distance) const;
};

/// Pieces at their place in float, edges in fours; what fills up the last four never matters.
class PiecePool {
  public:
    struct Piece {
        std::uint32_t first_quad, quads;
        std::uint32_t first_vertex, vertices;
        Vec2f centre;
        float radius;
        float corner_cosine;
    };

    void clear();

    /// Adds the piece turned by the angle of this cosine and sine, scaled, and moved.
    void add(const ConvexPiece& piece, double cosine, double sine, double scale,
             const Vec2& position);

    std::size_t size() const { return pieces_.size(); }
    const Piece& operator[](std::size_t i) const { return pieces_[i]; }
    const Float4* normal_x(const Piece& p) const { return &normal_x_[p.first_quad]; }
    const Float4* normal_y(const Piece& p) const { return &normal_y_[p.first_quad]; }
    const Float4* offset(const Piece& p) const { return &offset_[p.first_quad]; }
    const Vec2f* vertices(const Piece& p) const { return &vertices_[p.first_vertex]; }

  private:
    std::vector<Piece> pieces_;
    std::vector<Float4> normal_x_, normal_y_, offset_;
    std::vector<Vec2f> vertices_;
};

/// Angles around the one at which a piece stands in its pool, and scales.
struct TurnInterval {
    float cosine, sine; // of half the width of the interval of angles, less than pi / 2
    float low, high;    // scale
};

/// A convex polygon in fours of half-planes: normal . x <= offset.
struct HalfPlanes {
    std::vector<Float4> normal_x, normal_y, offset;
    void clear();
};

enum class NoFit {
    never,    // whatever angle and scale of the interval: the polygon never reaches the box
    not_here, // for the whole interval: this polygon does not
    found
};

/// Positions of the moving piece, about whose frame's origin it turns and scales, at which it
/// certainly comes nearer than `clearance` to the fixed piece at every angle and scale of the
/// interval: a subset of the exact set, that approaches it as the interval shrinks and the corners
/// are blunt. `moving` holds it at scale 1. Complete only when found; `box` is where it matters,
/// and `clearance` at most that of any part of the box and interval.
NoFit no_fit(const PiecePool& moving, const PiecePool::Piece& a, const TurnInterval& turn,
             const PiecePool& fixed, const PiecePool::Piece& b, float clearance,
             float largest_clearance, const Imath::Box2f& box, HalfPlanes& result);

} // namespace scree
