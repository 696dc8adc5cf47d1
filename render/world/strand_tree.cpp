// SPDX-License-Identifier: GPL-3.0-or-later
// Strands in the world: where they are met.
#include "render/world/strand_tree.h"

#include "core/frame.h"

#include <algorithm>

namespace scree {

namespace {

using Vertex = Imath::V4f; // position and radius

Vec3 position_of(const Vertex& v) { return {v.x, v.y, v.z}; }

// `from_axis` made unit; where the point is on the axis, any direction square to it.
Vec3 radial(const Vec3& from_axis, const Vec3& axis) {
    const float square = from_axis.dot(from_axis);
    return square > 0 ? from_axis / std::sqrt(square) : Frame(axis).x;
}

// The surface is that of all balls between the two at the ends: the nearest is the one whose
// surface has its normal through `p`.
StrandPoint onto_cone(const Vertex& a, const Vertex& b, const Vec3& p) {
    const Vec3 side = position_of(b) - position_of(a);
    const float length = std::sqrt(side.dot(side));
    StrandPoint out;
    out.axis = length > 0 ? side / length : Vec3(0.0F, 1.0F, 0.0F);
    const Vec3 from_a = p - position_of(a);
    const float along = from_a.dot(out.axis);
    const Vec3 across = from_a - out.axis * along;
    // The sine of the cone's half angle. With one ball inside the other there is no cone.
    const float sine = length > 0 ? std::clamp((a.w - b.w) / length, -0.999F, 0.999F) : 0;
    const float at = along - std::sqrt(across.dot(across)) * sine / std::sqrt(1 - sine * sine);
    out.fraction = length > 0 ? std::clamp(at / length, 0.0F, 1.0F) : 0;
    const Vec3 centre = position_of(a) + side * out.fraction;
    out.radius = a.w + (b.w - a.w) * out.fraction;
    out.segment_length = length;
    out.normal = radial(p - centre, out.axis);
    out.position = centre + out.normal * out.radius;
    return out;
}

/// A piece of a uniform cubic B-spline and its derivatives.
struct Piece {
    const Vertex* control; // four

    static Vertex mix(const Vertex* c, float w0, float w1, float w2, float w3) {
        return c[0] * w0 + c[1] * w1 + c[2] * w2 + c[3] * w3;
    }
    Vertex at(float u) const {
        const float v = 1 - u;
        return mix(control, v * v * v, 4 - 6 * u * u + 3 * u * u * u, 4 - 6 * v * v + 3 * v * v * v,
                   u * u * u) *
               (1.0F / 6);
    }
    Vertex first(float u) const {
        const float v = 1 - u;
        return mix(control, -v * v, -4 * u + 3 * u * u, 4 * v - 3 * v * v, u * u) * 0.5F;
    }
    Vertex second(float u) const { return mix(control, 1 - u, -2 + 3 * u, 1 - 3 * u, u); }
};

// The surface is that of all circles square to the curve.
StrandPoint onto_piece(const Piece& piece, const Vec3& p, float u) {
    constexpr int steps = 3; // of Newton's method; Embree's u is good to a few percent
    for (int i = 0; i < steps; ++i) {
        const Vec3 from_axis = p - position_of(piece.at(u));
        const Vec3 velocity = position_of(piece.first(u));
        const float slope = from_axis.dot(position_of(piece.second(u))) - velocity.dot(velocity);
        if (!(slope < 0))
            break; // beyond the centre of curvature
        u = std::clamp(u - from_axis.dot(velocity) / slope, 0.0F, 1.0F);
    }
    const Vertex centre = piece.at(u);
    const Vertex velocity = piece.first(u);
    const Vec3 side = position_of(velocity);
    const float speed = std::sqrt(side.dot(side));
    StrandPoint out;
    out.fraction = u;
    out.radius = centre.w;
    out.segment_length = speed;
    out.axis = speed > 0 ? side / speed : Vec3(0.0F, 1.0F, 0.0F);
    const Vec3 from_axis = p - position_of(centre);
    const Vec3 outwards = radial(from_axis - out.axis * from_axis.dot(out.axis), out.axis);
    out.position = position_of(centre) + outwards * out.radius;
    // The surface's own speed along the curve is less on the inner side of a bend.
    const float bend = speed > 0 ? outwards.dot(position_of(piece.second(u))) / speed : 0;
    const float surface_speed = std::max(speed - out.radius * bend, 1e-6F * speed);
    out.normal = speed > 0 ? unit(outwards - out.axis * (velocity.w / surface_speed)) : outwards;
    return out;
}

} // namespace

std::size_t strand_of(const Strands& strands, std::uint32_t first) {
    const std::vector<std::uint32_t>& offsets = strands.offsets;
    // Strands of equal length need no search.
    const auto guess =
        static_cast<std::size_t>(std::uint64_t{first} * strands.count() / strands.points.size());
    if (offsets[guess] <= first && first < offsets[guess + 1])
        return guess;
    return static_cast<std::size_t>(std::upper_bound(offsets.begin(), offsets.end(), first) -
                                    offsets.begin()) -
           1;
}

std::vector<std::uint16_t> chord_counts(const Strands& splines, std::size_t most) {
    constexpr float largest_count = 64; // of a piece, however sharply it bends
    std::vector<std::uint16_t> counts;
    counts.reserve(splines.segment_count());
    std::size_t sum = 0;
    for (std::size_t strand = 0; strand < splines.count(); ++strand)
        for (std::uint32_t i = splines.offsets[strand]; i + 3 < splines.offsets[strand + 1]; ++i) {
            const auto second = [&](std::uint32_t k) { // derivative; it is linear along the piece
                const Vec3 p =
                    splines.points[k] - splines.points[k + 1] * 2 + splines.points[k + 2];
                const float r = splines.radii[k] - splines.radii[k + 1] * 2 + splines.radii[k + 2];
                return std::sqrt(p.dot(p) + r * r);
            };
            const float radius = *std::max_element(&splines.radii[i], &splines.radii[i] + 4);
            // A chord over the n-th part of the parameter is off by a share of 1 / (8 n^2) of it.
            const float bend = std::max(second(i), second(i + 1));
            const float count = std::ceil(std::sqrt(bend / (8 * chord_tolerance * radius)));
            counts.push_back(count >= 1 ? static_cast<std::uint16_t>(std::min(count, largest_count))
                                        : std::uint16_t{1});
            sum += counts.back();
            if (sum > most)
                return {};
        }
    return counts;
}

std::size_t StrandTree::own_bytes() const {
    return chords.size() * sizeof(Chord) + own_vertices.size() * sizeof(Vertex) +
           own_firsts.size() * sizeof(std::uint32_t) + caps.size() * sizeof(StrandCap);
}

Vertex spline_vertex(const StrandTree& tree, std::uint32_t segment, float u) {
    return Piece{tree.vertices + tree.firsts[segment]}.at(u);
}

std::optional<StrandCap> end_cap(const StrandTree& tree, std::uint32_t segment, float u) {
    const Piece piece{tree.vertices + tree.firsts[segment]};
    const Vertex end = piece.at(u);
    const Vec3 outwards = position_of(piece.first(u)) * (u > 0 ? 1.0F : -1.0F);
    if (!(end.w > 0 && outwards.dot(outwards) > 0))
        return std::nullopt;
    return StrandCap{position_of(end), end.w, unit(outwards), u, segment};
}

std::vector<StrandCap> end_caps(const StrandTree& tree) {
    std::vector<StrandCap> caps;
    const auto add = [&](std::uint32_t segment, float u) {
        if (const std::optional<StrandCap> cap = end_cap(tree, segment, u))
            caps.push_back(*cap);
    };
    const Strands& splines = *tree.strands;
    const auto more = static_cast<std::uint32_t>(splines.piece_points() - 1);
    std::uint32_t segment = 0; // the first of the strand
    for (std::size_t i = 0; i < splines.count(); ++i) {
        const std::uint32_t next = segment + splines.offsets[i + 1] - splines.offsets[i] - more;
        add(segment, 0);
        add(next - 1, 1);
        segment = next;
    }
    return caps;
}

StrandPoint onto_cap(const StrandTree& tree, const StrandCap& cap, const Vec3& p) {
    const Piece piece{tree.vertices + tree.firsts[cap.segment]};
    StrandPoint out;
    out.fraction = cap.fraction;
    out.radius = cap.radius;
    out.segment_length = position_of(piece.first(cap.fraction)).length();
    out.axis = cap.outwards * (cap.fraction > 0 ? 1.0F : -1.0F);
    out.normal = radial(p - cap.centre, cap.outwards);
    out.position = cap.centre + out.normal * cap.radius;
    return out;
}

StrandPoint onto_segment(const StrandTree& tree, std::uint32_t segment, const Vec3& p, float u) {
    const Vertex* vertices = tree.vertices + tree.firsts[segment];
    return tree.strands->kind == CurveKind::linear ? onto_cone(vertices[0], vertices[1], p)
                                                   : onto_piece({vertices}, p, u);
}

} // namespace scree
