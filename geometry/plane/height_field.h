// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <string>

namespace scree {

/// A displacement map: what to add to a surface, as floats over a rectangle of known size. Channel
/// `Y` alone is a height along the surface's normal; channels `R`, `G`, `B` are the offset along x,
/// y and z of the flat map, where u runs along +x, v along -z, and y is the normal [m].
///
/// UV (0, 0) is the lower left corner of the image, whose row 0 is at the top; pixel centres lie at
/// half-integers, so pixel (i, j) holds the value at u = (i + 1/2) / width, v = 1 - (j + 1/2) /
/// height. Zero is the base plane.
struct HeightField {
    Image image;          // {"Y"} or {"R", "G", "B"} [m]
    Vec2 size{1.0, 1.0};  // of the whole image along u and v [m]
    double mid_level = 0; // the value that leaves the surface where it is [m]
    bool tiles = true;    // repeats seamlessly; otherwise its border pixels extend beyond it

    bool is_vector() const { return image.channels.size() == 3; }

    /// The height at a place: Catmull-Rom interpolation (Catmull & Rom 1974), which meets the
    /// pixels' values at their centres and has a continuous slope [m].
    float height(const Vec2& uv) const;

    /// The offset (x, y, z) at a place, interpolated likewise; (0, height, 0) without channels for
    /// x and z [m].
    Vec3 offset(const Vec2& uv) const;

    /// The same map with channels R, G, B.
    HeightField as_vector() const;

    /// The height alone, as channel Y.
    HeightField as_height() const;
};

/// Writes the map as a 32-bit float EXR atomically. Its header holds `worldSize` (v2f, m) and
/// `midlevel` (float, m) beside `metadata`. Throws Error (resource) on an unwritable path or a full
/// disk.
void write_height(const std::string& path, const HeightField& field, const Metadata& metadata = {});

/// Reads what `write_height` writes, or another program's EXR with the same channels and header.
/// Throws Error (input), naming the file, for other channels, a missing or impossible `worldSize`
/// and values that are not finite.
HeightField read_height(const std::string& path);

} // namespace scree
