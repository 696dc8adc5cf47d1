// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region.h"

namespace scree {

/// x' = a x + c y + e, y' = b x + d y + f, as the rows (a, b), (c, d), (e, f) of Imath's row-vector
/// matrix: p' = p * matrix.
using Affine = Imath::M33d;

/// Outlines of straight lines and Bezier curves, in the units of a drawing. Every subpath counts
/// as closed, as it does for filling.
class BezierPath {
  public:
    void move_to(const Vec2& to);
    void line_to(const Vec2& to);
    void quadratic_to(const Vec2& control, const Vec2& to);
    void cubic_to(const Vec2& control1, const Vec2& control2, const Vec2& to);

    /// SVG's elliptical arc: radii along the axes of an ellipse turned by `turn` [rad], the longer
    /// of the two ways round or not, and the direction. Each eighth of a turn is a cubic, 4e-6 of
    /// the radius from the ellipse. Radii too small for their ends are enlarged, a radius of 0
    /// gives a line (SVG 1.1, appendix F.6).
    void arc_to(Vec2 radii, double turn, bool large, bool clockwise, const Vec2& to);

    /// Back to where the subpath began; what follows without move_to begins there.
    void close();

    Vec2 current() const { return current_; }
    bool empty() const { return subpaths_.empty(); }

    void transform(const Affine& matrix);
    void append(const BezierPath& other);

    /// Closed polygons, none of whose chords is farther than `tolerance` from its curve; adds their
    /// number of points to `points` and stops when that exceeds `most`.
    std::vector<Ring> flatten(double tolerance, std::size_t& points, std::size_t most) const;

    /// Of all end and control points, between which the curves lie.
    Box2 control_box() const;

  private:
    struct Cubic {
        Vec2 control1, control2, to;
    };
    struct Subpath {
        Vec2 start;
        std::vector<Cubic> cubics; // a line's control points lie at its thirds
    };

    std::vector<Subpath> subpaths_;
    Vec2 current_{0.0};
    bool open_ = false; // whether the last subpath can be continued
};

} // namespace scree
