// SPDX-License-Identifier: GPL-3.0-or-later
// How much room an element needs: ellipses around it, along and across its x axis.
#pragma once

#include "geometry/plane/region.h"

namespace scree {

/// Semi-axes of an ellipse along and across an element's x axis [m].
struct EllipseAxes {
    double length = 0;
    double width = 0;

    /// Radius of the disk of the same area [m].
    double mean() const { return std::sqrt(length * width); }
};

/// The ellipse of least area about the centre of the region's bounding box that holds the region.
EllipseAxes enclosing_ellipse(const Region& region);

/// The same for the least disk.
EllipseAxes enclosing_disk(const Region& region);

/// The ellipse into which no other centre may come, so that two elements that fill `half` do not
/// overlap when their directions differ by no more than `spread` [rad]: twice as large as `half`
/// where they are alike, and otherwise of the least area with which either keeps the other away;
/// never larger than the disk about all turns. Found by search, and rounded to the safe side.
EllipseAxes exclusive_ellipse(const EllipseAxes& half, double spread);

/// What an element fills, and where no other centre of its class may come.
struct ElementRoom {
    EllipseAxes half;
    EllipseAxes exclusive;
};

/// The least distance r(a, b) of two classes [m] with which their elements do not overlap when
/// their exclusive ellipses are scaled to a mean radius of r: either must then hold the centre of
/// the other wherever the two touch.
double class_distance(const ElementRoom& a, const ElementRoom& b, double spread);

} // namespace scree
