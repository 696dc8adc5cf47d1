// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scree {

/// How the points of a strand make a curve.
enum class CurveKind {
    linear, // cones from point to point and a ball around each point; at least two points
    bspline // the control points of a uniform cubic B-spline, which has a piece for each four in a
            // row; at least four points
};

/// Curves with a radius at every point: hairs, fibres, stems. Strand i has the points from
/// offsets[i] to before offsets[i + 1]. Plain data.
struct Strands {
    std::string name;                   // as shown to users
    std::vector<Vec3> points;           // of all strands, one strand after the other [m]
    std::vector<float> radii;           // one per point [m]
    std::vector<std::uint32_t> offsets; // one more than there are strands; the first is 0
    std::vector<float> randoms;         // one per strand, uniform in [0, 1)
    // One per strand, unit length: square to the first segment, carried along without twist it
    // gives every point a frame.
    std::vector<Vec3> normals;
    CurveKind kind = CurveKind::linear;
    bool unit_unknown = false; // from a file whose numbers are taken as metres unasked

    std::size_t count() const { return offsets.empty() ? 0 : offsets.size() - 1; }

    /// Pieces of all strands: cones, or pieces of splines.
    std::size_t segment_count() const { return points.size() - count() * (piece_points() - 1); }

    /// How many points in a row make a piece.
    std::size_t piece_points() const { return kind == CurveKind::linear ? 2 : 4; }
};

} // namespace scree
