// SPDX-License-Identifier: GPL-3.0-or-later
// Making regions: all of these use `triangulate`, which checks its rings.
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/plane/region.h"

namespace scree {

/// Triangulates the area between the rings (constrained Delaunay), given in any order and
/// direction, by the even-odd rule: a ring in a ring is a hole, a ring in a hole another part.
/// Repeated points are dropped. Throws Error for a ring of fewer than three points, a number that
/// is not finite, and edges that cross, touch or fold back, naming ring and edge.
Region triangulate(std::vector<Ring> rings);

/// What is inside an outline that crosses itself: where the winding number is not 0, or is odd.
enum class FillRule { nonzero, evenodd };

/// Closed outlines that may cross, overlap and touch, with the rule that fills them. Of what they
/// fill only what lies in all of the clips `within` counts, which are given by their index.
struct FilledRings {
    std::vector<Ring> rings;
    FillRule rule = FillRule::nonzero;
    std::vector<std::size_t> within{};
};

/// A clip is the union of what its shapes fill, whose own clips have lower indices.
using Clips = std::vector<std::vector<FilledRings>>;

/// The union of what the shapes fill, as a valid region. Points are rounded to a grid of 2^-30 of
/// the longest side. Where parts or holes touch in a point only they are parted by cutting corners
/// of 1e-5 of the longest side, and what is smaller than the square of that vanishes. Throws Error
/// when nothing is filled, and for a number that is not finite.
Region fill(std::vector<FilledRings> shapes, const Clips& clips = {});

/// The region grown by a disk of radius `margin` [m] (Minkowski sum; for a negative margin eroded),
/// computed exactly for a regular 32-gon in place of the disk: circumscribed when growing,
/// inscribed when shrinking, so that the result always contains the exact offset, and nowhere is
/// more than 0.49% of |margin| away from it. Throws Error when nothing is left.
Region offset(const Region& region, double margin);

/// How closely `silhouette` follows the projection, as shares of its longest side.
struct SilhouetteDetail {
    int cells = 1024;         // of the raster along the longest side
    double tolerance = 0.005; // by which simplification may move an edge outwards
};

/// The outline of a mesh's projection onto the x-z plane. It contains the projection, and every
/// point of it is within (tolerance + 1.5 / cells) times the longest side of the projection:
/// triangles mark every cell of a raster that they touch, the marked cells' outline is simplified
/// outwards. Holes and parts larger than the tolerance stay. Throws Error for a mesh without
/// triangles, with numbers that are not finite, or whose projection is a line.
Region silhouette(const Mesh& mesh, const SilhouetteDetail& detail = {});

/// Removes vertices as long as no edge moves by more than `tolerance` [m] and always to the right
/// of its ring's direction, so that the area to the left only grows (progressive hulls, Sander et
/// al. 2000, in the plane). Rings stay simple and apart from each other.
void simplify_outward(std::vector<Ring>& rings, double tolerance);

} // namespace scree
