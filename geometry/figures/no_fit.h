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
struct NoFitPiece {
    std::vector<Vec2> vertices;
    std::vector<Vec2> normals;
    std::vector<double> offsets; // normal . x <= offset
    Vec2 centre;
    double radius = 0; // of a circle around the centre that holds the polygon [m]
    double corner_cosine = 1;

    /// `corner`: the largest angle between neighbouring normals [rad], at least pi / 2^20.
    NoFitPiece(const Ring& ring, double corner);

    /// Whether some point of it may be within `distance` [m] of the point.
    bool is_near(const Vec2& point, double distance) const;
};

/// Pieces at their place in float, edges in fours; the last four are filled up with edges that
/// constrain nothing.
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
    void add(const NoFitPiece& piece, double cosine, double sine, double scale,
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

/// An interval of angles around that of a piece in its pool, and one of scales.
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
    never,    // at no angle and scale of the interval does the polygon reach the box
    not_here, // the polygon for the whole interval does not reach the box
    found
};

/// Positions of the moving piece, about whose frame's origin it turns and scales, at which it
/// certainly comes nearer than `clearance` to the fixed piece at every angle and scale of the
/// interval: a subset of the exact set that approaches it as the interval shrinks, the more closely
/// the blunter the corners. `moving` holds the moving piece at scale 1. Only positions in `box`
/// matter, and `clearance` is at most that of any part of the box and interval. `result` is
/// complete only when found.
NoFit no_fit(const PiecePool& moving, const PiecePool::Piece& a, const TurnInterval& turn,
             const PiecePool& fixed, const PiecePool::Piece& b, float clearance,
             float largest_clearance, const Imath::Box2f& box, HalfPlanes& result);

} // namespace scree
