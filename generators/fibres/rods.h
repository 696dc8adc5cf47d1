// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/fibres/rotation.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scree::fibres {

/// Fibres that bend and twist but do not stretch: vertices, and a frame for each segment, whose y
/// axis lies along it (Kugelstadt & Schoemer 2016). All have the same number of segments.
struct Rods {
    std::uint32_t segments = 0;     // of each
    std::vector<Vec3> points{};     // [m]
    std::vector<Rotation> frames{}; // of the segments
    std::vector<Rotation> rest{};   // what turns a segment's frame to the next at rest
    std::vector<float> lengths{};   // of each fibre's segments [m]
    std::vector<float> radii{};     // at the vertices of any fibre [m]
    bool rooted = false;            // the first segments do not move

    std::size_t count() const { return lengths.size(); }
    std::size_t vertices() const { return segments + 1; }
    /// How easily the vertex `v` of a fibre moves.
    float mobility(std::uint32_t v) const { return rooted && v < 2 ? 0 : 1; }
};

/// Makes the shapes that rods have the ones that they are at rest in.
void take_shapes_as_rest(Rods& rods);

/// One rod among them, whose vertices may be elsewhere.
struct Rod {
    std::span<Vec3> points;
    std::span<Rotation> frames;
    std::span<const Rotation> rest;
    float length = 0; // of a segment [m]
    bool rooted = false;
};
inline Rod rod_of(Rods& rods, std::size_t fibre, std::vector<Vec3>& points) {
    const std::size_t n = rods.segments;
    return {std::span(points).subspan(fibre * (n + 1), n + 1),
            std::span(rods.frames).subspan(fibre * n, n),
            std::span<const Rotation>(rods.rest).subspan(fibre * (n - 1), n - 1),
            rods.lengths[fibre], rods.rooted};
}

/// Turns each frame by the shortest way so that it follows its segment.
void follow_segments(const Rod& rod);

/// One sweep forward and one back that take the joints `stiffness` of the way to their rest
/// (Kugelstadt & Schoemer 2016), first frames to each other, then vertices to the frames.
void restore_shape(const Rod& rod, float stiffness);

/// What `restore_lengths` works on, kept from rod to rod.
struct LengthWork {
    std::vector<Vec3> along;
    std::vector<float> excess, upper, move;
};

/// Moves vertices so that all segments have their length: at most three Newton steps, each of a
/// tridiagonal system (fast projection, Goldenthal et al. 2007).
void restore_lengths(const Rod& rod, LengthWork& work);

/// The largest error of a segment's length over that length.
double length_error(const Rods& rods);

} // namespace scree::fibres
