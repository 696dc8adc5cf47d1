// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/float4.h"
#include "geometry/figures/figure_pose.h"
#include "geometry/figures/inscribed_disks.h"
#include "geometry/plane/region.h"

#include <array>

namespace scree {

/// Four neighbouring edges of an outline in structure-of-arrays form, one SSE register each.
struct EdgeChunk {
    Float4 middle_x, middle_y;        // of the edge
    Float4 along_x, along_y;          // its direction, unit
    Float4 half;                      // of its length
    Float4 from_y, to_y;              // its ends, the same bits as its neighbours'
    float centre_x, centre_y, radius; // of a disk around all four
    int count;                        // of edges; the others are points at the last edge's end
};

/// A region prepared for overlap tests; its frame has the centre of the region's bounding box as
/// origin. Values in float are rounded; `overlap` allows for that.
class CollisionShape {
  public:
    explicit CollisionShape(const Region& region);

    const Vec2& centre() const { return centre_; }        // in the region's frame [m]
    double radius() const { return radius_; }             // of the circumscribed circle [m]
    double inner_radius() const { return inner_radius_; } // of the largest inscribed disk [m]
    double area() const { return area_; }                 // [m^2]
    const Region& outline() const { return outline_; }    // rings only, centred, exact
    /// One vertex of every outer ring: of shapes whose edges do not cross, these tell whether one
    /// contains the other.
    const std::vector<Vec2>& outer_vertices() const { return outer_vertices_; }

    const std::vector<Disk>& disks() const { return disks_; }
    const std::vector<EdgeChunk>& chunks() const { return chunks_; }

    /// The disks in float, in fours and one by one; the last four are filled up with disks at
    /// infinity.
    struct DiskChunk {
        Float4 x, y, radius;
    };
    const std::vector<DiskChunk>& disk_chunks() const { return disk_chunks_; }
    struct FloatDisk {
        float x, y, radius;
    };
    const std::vector<FloatDisk>& float_disks() const { return float_disks_; }

  private:
    void add_chunks(const Ring& ring);

    Vec2 centre_;
    double radius_ = 0;
    double inner_radius_ = 0;
    double area_ = 0;
    Region outline_;
    std::vector<Vec2> outer_vertices_;
    std::vector<Disk> disks_;
    std::vector<DiskChunk> disk_chunks_;
    std::vector<FloatDisk> float_disks_;
    std::vector<EdgeChunk> chunks_;
};

} // namespace scree
