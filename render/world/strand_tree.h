// SPDX-License-Identifier: GPL-3.0-or-later
// The strands of a World.
#pragma once

#include "geometry/mesh/strands.h"
#include "render/world/shape_tree.h"

#include <ImathVec.h>
#include <optional>
#include <utility>
#include <vector>

namespace scree {

/// Half a ball on an end of a spline, whose tube Embree leaves open (that of linear ones it
/// closes). Embree reads the centres and radii from here, 16 aligned bytes at a time.
struct alignas(16) StrandCap {
    Vec3 centre;
    float radius = 0;   // [m]
    Vec3 outwards;      // along the spline, unit
    float fraction = 0; // of its segment: 0 or 1
    std::uint32_t segment = 0;
};

/// One of the cones that stand for a piece of a spline in Embree's tree.
struct Chord {
    std::uint32_t piece = 0;
    std::uint16_t number = 0; // along the piece
    std::uint16_t of = 1;     // how many the piece has
};

/// Into how many cones the pieces of splines are cut so that none lies farther off the spline's
/// surface than `chord_tolerance`; empty when there are more than `most` in all.
std::vector<std::uint16_t> chord_counts(const Strands& splines, std::size_t most);

/// In radii.
inline constexpr float chord_tolerance = 0.01F;

/// What instances of the same strands share.
struct StrandTree : ShapeTree {
    static constexpr unsigned segments_id = 0; // of the geometry
    static constexpr unsigned caps_id = 1;

    const Strands* strands = nullptr;
    const Imath::V4f* vertices = nullptr;  // position and radius [m]
    const std::uint32_t* firsts = nullptr; // of each segment, its first vertex
    std::vector<StrandCap> caps;
    bool is_fibre = false; // too thin for its ends to be seen: they have no caps

    // Of splines that Embree sees as chains of cones. Otherwise empty, and the vertices and
    // segments are Embree's.
    std::vector<Chord> chords; // by Embree's primitive
    std::vector<Imath::V4f> own_vertices;
    std::vector<std::uint32_t> own_firsts;

    /// What it takes beside Embree's memory [B].
    std::size_t own_bytes() const;

    /// Fetches what `segment_at` reads of Embree's primitive, or the segment itself.
    void prefetch(std::uint32_t primitive) const {
        if (chords.empty())
            __builtin_prefetch(&firsts[primitive]);
        else
            __builtin_prefetch(&chords[primitive]);
    }

    /// The segment of Embree's primitive, and how far along it a hit at `u` of that is.
    std::pair<std::uint32_t, float> segment_at(std::uint32_t primitive, float u) const {
        if (chords.empty())
            return {primitive, u};
        const Chord& chord = chords[primitive];
        return {chord.piece, (static_cast<float>(chord.number) + u) / static_cast<float>(chord.of)};
    }
};

/// A point of a strand's surface, in the object's frame.
struct StrandPoint {
    Vec3 position;
    Vec3 normal;              // unit, outwards
    Vec3 axis;                // unit, towards the tip
    float radius = 0;         // [m]
    float fraction = 0;       // of the segment
    float segment_length = 0; // about [m]
};

/// The caps of both ends of all splines of the tree, but for ends without a radius.
std::vector<StrandCap> end_caps(const StrandTree& tree);

/// The cap of a spline's end, at the end `u` (0 or 1) of a segment; none for an end without a
/// radius.
std::optional<StrandCap> end_cap(const StrandTree& tree, std::uint32_t segment, float u);

/// The position and radius of the spline at the fraction `u` of a segment.
Imath::V4f spline_vertex(const StrandTree& tree, std::uint32_t segment, float u);

/// The strand that a segment belongs to, by the segment's first vertex.
std::size_t strand_of(const Strands& strands, std::uint32_t first);

/// The point of a segment's surface nearest to `p`, which lies near it. `u`: about what fraction of
/// the segment it is at. Embree's own hits lie up to 5% of the radius off the surface, and so do
/// their normals (Embree's issue 332).
StrandPoint onto_segment(const StrandTree& tree, std::uint32_t segment, const Vec3& p, float u);

/// The point of a cap nearest to `p`.
StrandPoint onto_cap(const StrandTree& tree, const StrandCap& cap, const Vec3& p);

} // namespace scree
